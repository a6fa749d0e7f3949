/// @file
/// HSP brightness: a perceived brightness on display-encoded values.
#pragma once

#include <cmath>

#include "core/base/host_device.h"
#include "core/math/vec.h"

namespace rtb {

/// sqrt(0.299 R^2 + 0.587 G^2 + 0.114 B^2) of sRGB-encoded values in [0, 1].
/// Source: D. R. Finley, "HSP Color Model - Alternative to HSV (HSB) and HSL",
/// 2006. Host and device.
RTB_HD inline double HspBrightness(const V3d& encoded) {
  return std::sqrt(0.299 * encoded.x * encoded.x +
                   0.587 * encoded.y * encoded.y +
                   0.114 * encoded.z * encoded.z);
}

}  // namespace rtb
