/// @file
/// Least squares: the glyph and the two colors that come nearest to the
/// samples of one cell. Samples -> FitCell -> Cell.
///
/// Everywhere here `samples` are one color of the blend space (ToBlend) for
/// each sub-pixel of the masks, row by row from the top left. A cell shows
/// m fg + (1 - m) bg at coverage m, mixed in the blend space; an error is the
/// sum of the squared differences over all sub-pixels and channels of that
/// space. Scalar and in double precision.
#pragma once

#include <span>

#include "encoders/blend.h"
#include "encoders/cell.h"
#include "encoders/fit/atlas.h"

namespace rtb {

/// A cell, what it costs, and the candidate of the atlas that it shows.
struct CellFit {
  Cell cell;
  double error = 0;
  int candidate = 0;
};

/// Of all candidates and all pairs of 8-bit colors the choice of least error;
/// of glyphs whose errors differ by no more than noise (kNoise) the one of the
/// lowest code point. A color that the glyph does not show is black.
///
/// For blend=oklab, where the channels of 8-bit colors depend on each other,
/// neighboring codes are searched until nothing improves.
CellFit FitCell(const Atlas& atlas, Blend blend, std::span<const V3d> samples);

/// The best pair of 8-bit colors for one mask. CellFit::candidate is 0.
CellFit RefitColors(const FitMask& mask, Blend blend,
                    std::span<const V3d> samples);

/// What a cell costs that shows the mask in its two colors, whatever its
/// glyph.
double ErrorOf(const FitMask& mask, const Cell& cell, Blend blend,
               std::span<const V3d> samples);

/// A fit whose colors are not rounded to 8 bits.
struct UnroundedFit {
  V3d fg{0};  ///< In the blend space, displayable.
  V3d bg{0};  ///< In the blend space, displayable.
  double error = 0;
  int candidate = 0;
};

/// The least error that any two displayable colors reach: what the glyphs
/// alone cost. (A color outside the displayable range is clamped and the other
/// solved again: exact for srgb and linear, where the range is a box.)
UnroundedFit FitCellUnrounded(const Atlas& atlas, Blend blend,
                              std::span<const V3d> samples);

/// The same for one mask. UnroundedFit::candidate is 0.
UnroundedFit RefitUnrounded(const FitMask& mask, Blend blend,
                            std::span<const V3d> samples);

}  // namespace rtb
