/// @file
/// Least squares with colors that are given: a terminal's palette, or one
/// fixed pair.
#pragma once

#include <span>
#include <vector>

#include "encoders/fit/fit.h"

namespace rtb {

/// Colors to choose from, prepared. Immutable; safe to share between threads.
class FitPalette {
 public:
  /// @param colors at least one.
  FitPalette(Blend blend, std::span<const Rgb8> colors);

  Blend blend() const { return blend_; }
  std::span<const Rgb8> colors() const { return colors_; }
  /// The colors in the blend space.
  std::span<const V3d> values() const { return values_; }

 private:
  Blend blend_;
  std::vector<Rgb8> colors_;
  std::vector<V3d> values_;
};

/// The candidate and the two colors of the palette that leave the least error
/// together; equal ones as in FitCell. A color that the glyph does not show is
/// the same as the other one.
CellFit FitCellToPalette(const Atlas& atlas, const FitPalette& palette,
                         std::span<const V3d> samples);

/// The best pair of the palette for one mask. CellFit::candidate is 0.
CellFit RefitToPalette(const FitMask& mask, const FitPalette& palette,
                       std::span<const V3d> samples);

/// The candidate that comes nearest in the two given colors.
CellFit FitCellToColors(const Atlas& atlas, Blend blend,
                        std::span<const V3d> samples, Rgb8 fg, Rgb8 bg);

}  // namespace rtb
