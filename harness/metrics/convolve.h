/// @file
/// Separable filtering of planes.
#pragma once

#include <vector>

#include "harness/metrics/channel_plane.h"

namespace rtb {

/// Weights at offsets -radius .. radius; its length is 2 radius + 1.
using Kernel = std::vector<double>;

/// exp(-x^2 / (2 sigma^2)) at whole x, scaled to sum to 1; sigma in pixels.
Kernel GaussianKernel(double sigma, int radius);

/// Sum over k of kernel[k] in(x + k, y), borders replicated.
ChannelPlane FilterRows(const ChannelPlane& in, const Kernel& kernel,
                        int threads);

/// Sum over k of kernel[k] in(x, y + k), borders replicated.
ChannelPlane FilterColumns(const ChannelPlane& in, const Kernel& kernel,
                           int threads);

/// Both, with one kernel.
ChannelPlane Filter(const ChannelPlane& in, const Kernel& kernel, int threads);

}  // namespace rtb
