/// @file
/// Relative luminance, and luma: the same weights on encoded values.
#pragma once

#include <Imath/ImathVec.h>

#include "core/base/host_device.h"

namespace rtb {

/// Rec. ITU-R BT.709-6, item 3.2: the weighted sum of the three components.
/// Of linear values this is relative luminance Y, of sRGB-encoded ones the
/// luma Y'. White has 1.
template <class T>
RTB_HD inline T Luminance(const Imath::Vec3<T>& rgb) {
  return T(0.2126) * rgb.x + T(0.7152) * rgb.y + T(0.0722) * rgb.z;
}

}  // namespace rtb
