/// @file
/// Pictures of where a test image errs.
#pragma once

#include "core/image/image.h"
#include "harness/metrics/metric.h"

namespace rtb {

/// FLIP of each pixel at kFlipPpd in the colors of magma, dark for 0 and light
/// for 1, as the authors' tool draws it. sRGB-encoded.
Image FlipPicture(const MetricInput& input);

/// The absolute difference of the encoded values, channel by channel, as a
/// picture of its own.
Image DifferencePicture(const MetricInput& input);

}  // namespace rtb
