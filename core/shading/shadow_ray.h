/// @file
/// Shadow rays, host and device.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/accel/surface.h"
#include "core/base/host_device.h"
#include "core/shading/light_data.h"

namespace rtb {

/// How far short of a light's own surface a shadow ray has to end: a bound of
/// the error with which a ray meets it - that of LeavingOrigin, at the ray's
/// slant. 0 for lights without extent.
/// @param end where the ray, whose unit direction is given, meets the light.
RTB_HD inline float ShadowMargin(const LightData& light, const V3f& origin,
                                 const V3f& direction, const V3f& end) {
  if (!HasExtent(light)) return 0;
  V3f normal = light.direction;
  float extent = light.radius;
  if (light.model == LightModel::kSphere) {
    normal = (end - light.position) / light.radius;
  } else {
    extent = MaxAbs(light.edge0) + MaxAbs(light.edge1);
  }
  const float scale = std::max(MaxAbs(light.position) + extent, MaxAbs(origin));
  // More than a slant of 1 in 64 would cost length for rays that carry little.
  const float slant = std::max(1.0f / 64, std::abs(normal.dot(direction)));
  return 0x1p-20f * scale / slant;
}

/// The ray that decides whether a sample of a light reaches a surface. It is
/// aimed anew from where it starts: the step off a large surface may be large
/// against the distance to the light.
/// @param sample as seen from the surface's point.
RTB_HD inline Ray ShadowRay(const SurfacePoint& from, const LightData& light,
                            const LightSample& sample) {
  Ray ray;
  ray.origin = LeavingOrigin(from, sample.direction);
  ray.direction = sample.direction;
  if (light.model == LightModel::kDirectional) return ray;
  const V3f end = from.position + sample.direction * sample.distance;
  const V3f way = end - ray.origin;
  const float distance = way.length();
  ray.t_max = 0;
  if (!(distance > 0)) return ray;
  ray.direction = way / distance;
  ray.t_max = distance - ShadowMargin(light, ray.origin, ray.direction, end);
  return ray;
}

}  // namespace rtb
