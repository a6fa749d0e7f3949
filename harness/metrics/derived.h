/// @file
/// What several metrics derive from a pair of images; each is computed once a
/// pair.
#pragma once

#include "harness/metrics/channel_plane.h"
#include "harness/metrics/metric.h"

namespace rtb {

/// Something of both images.
template <class T>
struct OfBoth {
  T reference;
  T test;
};

/// Linear BT.709 values in [0, 1] of both images.
const OfBoth<ColorPlanes>& LinearPlanes(const MetricInput& input);

/// Luma of both images: the weighted sum of encoded values, not rounded.
const OfBoth<ChannelPlane>& LumaPlanes(const MetricInput& input);

}  // namespace rtb
