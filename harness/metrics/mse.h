/// @file
/// Mean squared error, which MSE and PSNR share.
#pragma once

#include "harness/metrics/metric.h"

namespace rtb {

/// Mean over pixels and channels of the squared difference of sRGB-encoded
/// values.
double MeanSquaredError(const MetricInput& input);

}  // namespace rtb
