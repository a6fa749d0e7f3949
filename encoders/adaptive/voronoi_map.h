/// @file
/// VoronoiMap: the sample nearest to each slot of a grid, and how much a sample
/// there could still tell. SeenSamples -> VoronoiMap -> ChooseRays.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "encoders/adaptive/slot_kernels.h"

namespace rtb {

/// How contrasts count.
enum class Priority {
  kSquare,  ///< As in a squared error.
  kRoot,    ///< By the root of that: faint contrasts count more.
};

/// A discrete Voronoi diagram of all samples over all slots of the grid.
class VoronoiMap {
 public:
  VoronoiMap(GridSize grid, double cell_aspect, Priority priority);

  /// Enters samples. Their cells must not fall.
  /// @param reaches how far from each of them slots may be nearest to it, at
  ///   most kCellHeight.
  void Insert(std::span<const SeenSample> samples,
              std::span<const float> reaches, int threads);

  /// The slots of one cell. A slot's contrast is the larger one of those
  /// between its neighbors to the left and right, and above and below: the
  /// squared distance of the encoded colors of the samples that are nearest to
  /// them, or its root.
  CellSlots Slots(int cell) const;

  /// The largest gain among the slots of each cell.
  std::span<const float> best_gains() const { return best_gains_; }

  float cell_width() const { return cell_width_; }

 private:
  /// A rectangle of slots, all sides included.
  struct Window {
    int left, top, right, bottom;
  };

  void InsertIntoRow(int row, std::span<const SeenSample> samples,
                     std::span<const float> reaches);
  void Enter(const SeenSample& sample, const V2f& at, const Window& window);
  /// The slots from (left, top) on.
  SlotRows RowsFrom(int left, int top, int columns, int rows);
  void RepeatBorder();
  bool ChangedAround(int cell) const;
  void CompareRow(int row);
  /// The contrasts and best gains of cells side by side.
  void Compare(int row, int begin, int end);
  /// Index of a slot; -1 and one past the last are the border.
  std::size_t Index(int x, int y) const {
    return static_cast<std::size_t>(y + 1) * stride_ +
           static_cast<std::size_t>(x + 1);
  }

  GridSize grid_;
  Priority priority_;
  float cell_width_;
  float pitch_x_;  ///< From slot to slot.
  float pitch_y_;
  std::size_t stride_;
  /// Of each slot, with a border all around in which colors are repeated, and
  /// kSlotRoom floats after each row.
  std::vector<float> distance2_;
  std::array<std::vector<float>, 3> color_;
  std::vector<float> contrast_;
  std::vector<float> extent_;
  /// Of each cell.
  std::vector<float> best_gains_;
  std::vector<std::uint8_t> changed_;
};

}  // namespace rtb
