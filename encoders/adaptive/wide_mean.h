/// @file
/// Places as means of all samples around: what is to be expected where the
/// nearest ones tell nothing.
#pragma once

#include <span>

#include "encoders/adaptive/blend_nearest.h"

namespace rtb {

/// Squared distance at which a sample counts half as much in a wide mean as one
/// at the place itself: wide enough that some tens of them count.
inline constexpr float kWideReach2 = 9;

/// What a sample counts in a wide mean.
inline float WideWeight(float dx, float dy) {
  return 1 / (dx * dx + dy * dy + kWideReach2);
}

/// The wide means at the first `out.size()` places: halfway between that of the
/// encoded values and that of linear light, as what the samples differ by may
/// be coarser or finer than a pixel.
/// @param near at least one sample.
void BlendWide(const NearSamples& near, const BlendPlaces& places,
               std::span<Rgb> out);

}  // namespace rtb
