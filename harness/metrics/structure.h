/// @file
/// Structural similarity of two planes, which SSIM and MS-SSIM share.
#pragma once

#include "harness/metrics/channel_plane.h"

namespace rtb {

/// Side of SSIM's window, in pixels.
inline constexpr int kSsimWindow = 11;

/// Means over the positions at which the whole window lies inside.
struct Structure {
  double similarity;  ///< l c s, equation (13) of Wang et al. 2004.
  double contrast;    ///< c s alone, without the luminance term.
};

/// Both planes have the same size, at least kSsimWindow in both directions;
/// values in [0, 1].
Structure CompareStructure(const ChannelPlane& a, const ChannelPlane& b,
                           int threads);

}  // namespace rtb
