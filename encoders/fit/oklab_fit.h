/// @file
/// Two colors of one mask in OKLab, where the range of display colors is no
/// box and the channels of a code depend on each other.
#pragma once

#include "encoders/fit/color_fit.h"

namespace rtb {

/// SolveDisplayable for Blend::kOklab.
ColorPair SolveOklab(const FitMask& mask, const CenteredSamples& samples,
                     const V3d& correlation);

/// SolveCodes for Blend::kOklab: from the rounded pair on, the neighbors of
/// either color and of both in opposite and equal steps, until none is better.
CodesFit SolveOklabCodes(const FitMask& mask, const CenteredSamples& samples,
                         const V3d& correlation);

}  // namespace rtb
