/// @file
/// BoundResult: the least error that any encoder of the same glyphs can have.
#pragma once

#include <optional>
#include <string>

namespace rtb {

/// How a run compares with what its glyph set can do.
struct BoundResult {
  std::string glyphs;  ///< Names of glyph lists joined by `+`, or a count.
  /// Least MSE of any two colors a cell, not rounded, over the glyph set on
  /// the reference's raster.
  double mse = 0;
  std::optional<double> gap;  ///< The run's MSE / `mse`; none where that is 0.
  bool operator==(const BoundResult&) const = default;
};

}  // namespace rtb
