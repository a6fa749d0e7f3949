/// @file
/// ByCell: what `adaptive` has seen, sorted by cell. SeenSamples -> ByCell ->
/// Reliances and Rebuild.
#pragma once

#include <cstddef>
#include <vector>

#include "encoders/adaptive/blend_nearest.h"
#include "encoders/adaptive/samples.h"

namespace rtb {

/// The samples sorted by cell, in their order.
class ByCell {
 public:
  /// @param samples must outlive this.
  ByCell(const SeenSamples& samples, double cell_aspect);

  GridSize grid() const { return grid_; }
  float cell_width() const { return cell_width_; }

  /// Those in the cell and up to half its height around it, row by row of
  /// cells.
  void Gather(int cell, NearSamples& near) const;

 private:
  void AddOf(int cell, float left, float top, NearSamples& near) const;

  GridSize grid_;
  float cell_width_;
  std::vector<std::size_t> begin_;
  std::vector<const SeenSample*> sorted_;
};

}  // namespace rtb
