/// @file
/// VoronoiMap: the sample nearest to each slot of a grid, and how much a sample
/// there could still tell. SeenSamples -> VoronoiMap -> ChooseRays.
#pragma once

#include <hwy/aligned_allocator.h>

#include <cstdint>
#include <span>
#include <vector>

#include "encoders/adaptive/choose_in_cell.h"
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

  /// What to choose one of a cell's rays from: its slots, without the rest.
  CellChoice ChoiceIn(int cell) const;

  /// Fetches what ChoiceIn will point to.
  void Prefetch(int cell) const;

  /// The largest gain among the slots of each cell.
  std::span<const float> best_gains() const { return best_gains_; }

  float cell_width() const { return cell_width_; }

 private:
  void InsertIntoRows(int first, int last, std::span<const SeenSample> samples,
                      std::span<const float> reaches);
  void RepeatBorder();

  Priority priority_;
  float cell_width_;
  SlotGrid slots_;
  hwy::AlignedFreeUniquePtr<float[]> fields_;  ///< What slots_ points to.
  std::vector<std::uint32_t> changed_;         ///< As well.
  std::vector<float> best_gains_;              ///< Of each cell.
};

}  // namespace rtb
