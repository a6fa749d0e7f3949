/// @file
/// How far a shadow ray goes, host and device.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/accel/surface.h"
#include "core/base/host_device.h"
#include "core/shading/light_data.h"

namespace rtb {

/// The length of a shadow ray that leaves `from`: all the way to a light
/// without extent, else short of the light's own surface by a bound of the
/// error with which a ray meets it, at the ray's slant: that of LeavingOrigin
/// for the light, and the distance by which that moves the ray's start, which
/// grows with the surface that it leaves.
RTB_HD inline float ShadowReach(const LightData& light,
                                const SurfacePoint& from,
                                const LightSample& sample) {
  if (!HasExtent(light)) return sample.distance;
  const V3f& position = from.position;
  V3f normal = light.direction;
  float extent = light.radius;
  if (light.model == LightModel::kSphere) {
    normal = (position + sample.direction * sample.distance - light.position) /
             light.radius;
  } else {
    extent = MaxAbs(light.edge0) + MaxAbs(light.edge1);
  }
  const float scale =
      std::max(MaxAbs(light.position) + extent, MaxAbs(position));
  // More than a slant of 1 in 64 would cost length for rays that carry little.
  const float slant =
      std::max(1.0f / 64, std::abs(normal.dot(sample.direction)));
  return sample.distance - 0x1p-20f * (scale + from.scale) / slant;
}

}  // namespace rtb
