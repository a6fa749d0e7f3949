/// @file
/// The least squares of one channel, for spaces whose channels do not depend
/// on each other (srgb and linear).
#pragma once

#include <span>

#include "encoders/blend.h"
#include "encoders/fit/atlas.h"

namespace rtb {

/// A squared error as a function of the two colors, each counted from the
/// mean of the samples:
///   aa fg^2 + 2 ab fg bg + bb bg^2 - 2 p (fg - bg), plus a constant.
/// (The samples being centered, their products with m and with 1 - m add up
/// to 0.)
struct PairCost {
  double aa;  ///< Sum of m^2.
  double ab;  ///< Sum of m (1 - m).
  double bb;  ///< Sum of (1 - m)^2.
  double p;   ///< Sum of m times sample.

  PairCost(const FitMask& mask, double correlation)
      : aa(mask.sum_squares),
        ab(mask.sum - mask.sum_squares),
        bb(mask.size() - 2 * mask.sum + mask.sum_squares),
        p(correlation) {}

  double At(double fg, double bg) const {
    return aa * fg * fg + 2 * ab * fg * bg + bb * bg * bg - 2 * p * (fg - bg);
  }
  /// The same with the roles of foreground and background changed.
  PairCost Swapped() const {
    PairCost swapped = *this;
    swapped.aa = bb;
    swapped.bb = aa;
    swapped.p = -p;
    return swapped;
  }
  /// The best bg beside a given fg; 0 where none counts.
  double BestBg(double fg) const { return bb > 0 ? (-p - ab * fg) / bb : 0; }
};

/// Two values of one channel, counted from the samples' mean.
struct ValuePair {
  double fg;
  double bg;
};

/// The best pair, anywhere.
ValuePair SolvePair(const FitMask& mask, double correlation);

/// The best pair of which both values are in [low, high].
ValuePair SolvePairWithin(const FitMask& mask, double correlation, double low,
                          double high);

/// Two codes of one channel with their cost by PairCost.
struct CodePair {
  int fg = 0;
  int bg = 0;
  double cost = 0;
};

/// The pair of 8-bit codes of least cost, of all 65536. Where a color counts
/// by itself, rounding is half up, noise aside; a color of no weight is 0.
/// @param values the 256 codes in the blend space, rising.
/// @param mean of the samples, from which the costs are counted.
CodePair BestCodes(const FitMask& mask, double correlation,
                   std::span<const double, 256> values, double mean);

/// The values of the 256 codes of one channel. Not for kOklab.
std::span<const double, 256> CodeValues(Blend blend);

}  // namespace rtb
