/// @file
/// Quad and triangle lights, sampled uniformly over their area.
#pragma once

#include <cmath>

#include "core/base/host_device.h"
#include "core/shading/light_data.h"

namespace rtb {

/// Whether a flat light shines on a viewer who looks along `direction`: quads
/// on the side of edge0 x edge1, triangles on both.
RTB_HD inline bool ShinesAgainst(const LightData& light, const V3f& direction) {
  const float cosine = light.direction.dot(direction);
  return light.model == LightModel::kTriangle ? cosine != 0 : cosine < 0;
}

/// Uniform density over the area, per solid angle: distance^2 / (area cos);
/// 0 where that is no usable number.
/// @param direction unit, from the viewer to the point on the light.
RTB_HD inline float AreaPdf(const LightData& light, const V3f& direction,
                            float distance) {
  const float projected = std::abs(light.direction.dot(direction)) * light.area;
  const float pdf = distance * distance / projected;
  return IsUsableDensity(pdf) ? pdf : 0;
}

/// The point of a quad or triangle light for u of the unit square.
RTB_HD inline V3f AreaPoint(const LightData& light, const V2f& u) {
  if (light.model != LightModel::kTriangle) {
    return light.position + (light.edge0 * u.x + light.edge1 * u.y);
  }
  // Turk, "Generating Random Points in Triangles", Graphics Gems, 1990.
  const float root = std::sqrt(u.x);
  return light.position +
         (light.edge0 * (1 - root) + light.edge1 * (u.y * root));
}

/// A quad or triangle light from `position`.
RTB_HD inline LightSample SampleArea(const LightData& light,
                                     const V3f& position, const V2f& u) {
  const V3f to_light = AreaPoint(light, u) - position;
  const float distance = to_light.length();
  const V3f direction = to_light / distance;
  if (!(distance > 0) || !ShinesAgainst(light, direction)) return {};
  const float pdf = AreaPdf(light, direction, distance);
  if (!(pdf > 0)) return {};
  return {direction, distance, light.color / pdf, pdf};
}

}  // namespace rtb
