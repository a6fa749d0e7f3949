/// @file
/// sRGB-encoded values as whole numbers, for encoders that average and compare
/// in that space: sums are exact in any order, equal errors are equal, and
/// scalar and vector code agree.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>

#include "core/base/host_device.h"
#include "core/color/srgb_scalar.h"
#include "core/math/vec.h"

namespace rtb {

/// An 8-bit code has this many steps, so that a step is about kNoise. Codes
/// that have been to linear light and back are whole codes again, for both
/// ways together err by less than 0.3 steps; and the sum of 8 values of at
/// most 255 codes is exact in single precision (2^24).
inline constexpr int kStepsPerCode = 8192;

/// Steps of the encoded value 1.
inline constexpr int kWhiteSteps = 255 * kStepsPerCode;

/// A color in steps.
using StepColor = Imath::Vec3<std::int32_t>;

/// A linear value, clipped to [0, 1] (NaN is 0), sRGB-encoded and rounded to
/// steps.
std::int32_t EncodedSteps(float linear);

/// The same by a table that is given. Host and device.
RTB_HD inline std::int32_t EncodedStepsBy(const SrgbCurveTable& curve,
                                          float linear) {
  return static_cast<std::int32_t>(std::nearbyint(
      SrgbEncodeBy(curve, linear) * static_cast<float>(kWhiteSteps)));
}

/// The same for colors. Both spans have one length.
void EncodedSteps(std::span<const Rgb> linear, std::span<StepColor> steps);

/// The encoded color in [0, 1] that steps stand for.
RTB_HD inline V3d FromSteps(const StepColor& steps) {
  return V3d(steps.x, steps.y, steps.z) / kWhiteSteps;
}

}  // namespace rtb
