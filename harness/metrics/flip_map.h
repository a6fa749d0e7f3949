/// @file
/// The error map of LDR-FLIP.
#pragma once

#include "harness/metrics/channel_plane.h"
#include "harness/metrics/metric.h"

namespace rtb {

/// Pixels per degree: the primary measure (a terminal on a desktop), a
/// closer view, and the default of FLIP's authors (0.7 m from a 3840 pixel
/// screen 0.7 m wide).
inline constexpr double kFlipPpd = 40;
inline constexpr double kFlipPpdNear = 30;
inline constexpr double kFlipPpdFar = 67.0206433;

/// FLIP of each pixel, 0 (equal) to 1, after Andersson et al. 2020 and the
/// authors' tool, version 1.6. Computed once for a pair and `ppd`.
const ChannelPlane& FlipMap(const MetricInput& input, double ppd);

/// Mean of the map.
double MeanFlip(const MetricInput& input, double ppd = kFlipPpd);

/// The map of two images given by linear BT.709 values in [0, 1].
ChannelPlane FlipMapOfLinear(const ColorPlanes& reference,
                             const ColorPlanes& test, double ppd, int threads);

}  // namespace rtb
