/// @file
/// The checker texture, host and device.
#pragma once

#include <cmath>

#include "core/base/host_device.h"
#include "core/math/vec.h"

namespace rtb {

/// Checker in object space; size 0 = none.
struct CheckerData {
  Rgb a{0};
  Rgb b{0};
  float size = 0;
};

/// The checker's color at a point of object space, moved by size/1000 along
/// the unit geometric normal so that a face on a cell border never flickers.
RTB_HD inline Rgb CheckerColor(const CheckerData& checker, const V3f& position,
                               const V3f& normal) {
  const V3f p = position / checker.size + normal * 0.001f;
  // The parity of a sum of floors, each reduced first: no overflow, far out.
  const float sum = std::fmod(std::floor(p.x), 2.0f) +
                    std::fmod(std::floor(p.y), 2.0f) +
                    std::fmod(std::floor(p.z), 2.0f);
  return std::fmod(sum, 2.0f) == 0 ? checker.a : checker.b;
}

}  // namespace rtb
