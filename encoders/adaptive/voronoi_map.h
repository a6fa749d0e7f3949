/// @file
/// VoronoiMap: the sample nearest to each slot of a grid, and how much a sample
/// there could still tell. SeenSamples -> VoronoiMap -> RayChooser.
#pragma once

#include <hwy/aligned_allocator.h>

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
  /// Start or Clear comes first.
  VoronoiMap(GridSize grid, double cell_aspect, Priority priority);

  /// Begins without samples.
  void Clear();

  /// Begins with the same number of samples in every cell.
  /// @param samples cell by cell.
  /// @param positions of those of each cell.
  void Start(std::span<const SeenSample> samples,
             std::span<const V2f> positions, int threads);

  /// Enters samples. Their cells must not fall. Each is nearest to slots of the
  /// blocks around its own at most: no limit after Start, unless with a single
  /// sample in each of very narrow or wide cells.
  void Insert(std::span<const SeenSample> samples, int threads);

  /// The slots of one cell. A slot's contrast is the larger one of those
  /// between its neighbors to the left and right, and above and below: the
  /// squared distance of the encoded colors of the samples that are nearest to
  /// them, or its root. It is kept squared.
  const CellSlots& Slots(int cell) const {
    return cells_[places_[static_cast<std::size_t>(cell)]];
  }

  /// The largest gain among the slots of each cell.
  std::span<const float> best_gains() const { return best_gains_; }

  float cell_width() const { return cell_width_; }

 private:
  void InsertIntoRows(int first, int last, std::span<const SeenSample> samples);
  void Compare(int threads);
  void RepeatBorder();
  void BoundAround();

  Priority priority_;
  float cell_width_;
  SlotGrid slots_;
  /// @name What slots_ points to.
  /// @{
  hwy::AlignedFreeUniquePtr<CellSlots[]> cells_;
  std::vector<std::uint32_t> changed_;
  std::vector<float> farthest_, around_, gains_;
  /// @}
  std::vector<std::uint32_t> places_;  ///< Of each cell, in cells_.
  std::vector<float> best_gains_;      ///< Of each cell.
};

}  // namespace rtb
