/// @file
/// The two colors of one mask: channel by channel, or in OKLab together.
#pragma once

#include "encoders/blend.h"
#include "encoders/fit/moments.h"

namespace rtb {

/// Two colors of the blend space.
struct ColorPair {
  V3d fg{0};
  V3d bg{0};
};

/// Two display colors, and what they leave of the squared error.
struct CodesFit {
  Rgb8 fg;
  Rgb8 bg;
  double error = 0;
};

/// The squared error of a mask in two colors, from the samples' sums.
double ErrorOfPair(const FitMask& mask, const CenteredSamples& samples,
                   const V3d& correlation, const ColorPair& colors);

/// The best pair of displayable colors, unrounded (FitCellUnrounded says how).
ColorPair SolveDisplayable(const FitMask& mask, Blend blend,
                           const CenteredSamples& samples,
                           const V3d& correlation);

/// The best pair of 8-bit colors (FitCell says how).
CodesFit SolveCodes(const FitMask& mask, Blend blend,
                    const CenteredSamples& samples, const V3d& correlation);

}  // namespace rtb
