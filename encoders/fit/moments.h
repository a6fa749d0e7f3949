/// @file
/// The sums of the normal equations that depend on the picture.
#pragma once

#include <span>
#include <vector>

#include "core/math/vec.h"
#include "encoders/fit/atlas.h"

namespace rtb {

/// The samples of one cell around their mean: what is left of them is small
/// where a cell is nearly of one color, and the sums lose nothing.
struct CenteredSamples {
  V3d mean{0};
  double squares = 0;     ///< Over all samples and channels.
  std::vector<V3d> rest;  ///< Sample - mean.
};

CenteredSamples Center(std::span<const V3d> samples);

/// Sum of coverage times sample, over the sub-pixels.
V3d Correlate(const FitMask& mask, const CenteredSamples& samples);

/// What the two best colors, unrounded and unclamped, leave of the squared
/// error: no other choice of colors is better. With d = fg - bg and the
/// samples centered it is squares - 2 d p + d^2 variance at its least.
double LeastError(const FitMask& mask, const CenteredSamples& samples,
                  const V3d& correlation);

}  // namespace rtb
