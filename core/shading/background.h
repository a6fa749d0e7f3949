/// @file
/// The radiance that rays bring from beyond the scene.
#pragma once

#include <algorithm>

#include "core/base/host_device.h"
#include "core/math/vec.h"

namespace rtb {

/// bottom + (top - bottom) * 0.5 * (y + 1); a constant has both equal.
struct BackgroundData {
  Rgb bottom{0};
  Rgb top{0};
};

/// Radiance from a unit direction.
RTB_HD inline Rgb BackgroundRadiance(const BackgroundData& background,
                                     const V3f& direction) {
  return background.bottom +
         (background.top - background.bottom) * (0.5f * (direction.y + 1));
}

}  // namespace rtb
