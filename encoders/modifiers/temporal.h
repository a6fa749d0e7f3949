/// @file
/// Temporal stability: the last frame's cells are kept while noise explains
/// the difference.
#pragma once

#include "encoders/cell.h"
#include "encoders/fit/fit.h"

namespace rtb {

/// How far a cell may be behind the best one before it is replaced. All in the
/// blend space; errors are sums over a cell's samples and channels.
struct StabilityTest {
  double z = 3;           ///< Standard deviations that count as noise.
  double sigma = 0;       ///< Standard deviation of a sample's noise.
  double partitions = 1;  ///< Masks that the encoder may choose from.

  /// The excess over `best` that noise explains in a mask and its two colors:
  ///   sigma^2 (d + z sqrt(2 d + 24)) + 2 z sigma sqrt(best)
  /// with d = 12 + 2 log2(partitions). The 12 are the 6 values of two colors,
  /// each with the noise of both frames: 6 squares of variance 2 sigma^2, whose
  /// sum has the variance 48 sigma^4, 24 more than 2 d counts.
  double CellMargin(double best) const;
  /// The same for a mask whose colors are fitted anew, d = 2 log2(partitions):
  ///   sigma^2 (d + z sqrt(2 d)) + 2 z sigma sqrt(best).
  double MaskMargin(double best) const;
};

/// A cell with what is needed to judge it.
struct JudgedCell {
  Cell cell;
  const FitMask& mask;
};

/// What to show: the last frame's cell while its error is within the margin of
/// `best`'s and nothing around it `drifted`; failing that its glyph in new
/// colors, under the stricter test; else `best`.
/// @param refit the best colors for the last glyph, of what `samples` show.
/// @param weight Evidence::weight.
template <class Refit>
Cell KeepOrReplace(const StabilityTest& test, const JudgedCell& best,
                   const JudgedCell& last, Blend blend,
                   std::span<const V3d> samples, double weight, bool drifted,
                   const Refit& refit) {
  const auto error = [&](const JudgedCell& judged) {
    return weight * ErrorOf(judged.mask, judged.cell, blend, samples);
  };
  const double least = error(best);
  if (!drifted && error(last) - least <= test.CellMargin(least)) {
    return last.cell;
  }
  const JudgedCell recolored{refit(last), last.mask};
  if (error(recolored) - least <= test.MaskMargin(least)) {
    return recolored.cell;
  }
  return best.cell;
}

}  // namespace rtb
