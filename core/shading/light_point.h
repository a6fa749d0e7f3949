/// @file
/// Lights without extent: point, directional and spot lights.
#pragma once

#include <cmath>
#include <limits>

#include "core/base/host_device.h"
#include "core/shading/light_data.h"

namespace rtb {

/// A directional light, the same from everywhere.
RTB_HD inline LightSample SampleDirectionalLight(const LightData& light) {
  return {-light.direction, std::numeric_limits<float>::infinity(), light.color,
          0};
}

/// A point light from `position`; black at the light itself.
RTB_HD inline LightSample SamplePointLight(const LightData& light,
                                           const V3f& position) {
  const V3f to_light = light.position - position;
  const float distance = to_light.length();
  if (!(distance > 0)) return {};
  const Rgb irradiance =
      light.inverse_square ? light.color / distance / distance : light.color;
  return {to_light / distance, distance, irradiance, 0};
}

/// The share of a spot's intensity along a unit direction of travel: 1 within
/// the cone, then 1 - smoothstep of the angle, 0 past the penumbra.
RTB_HD inline float SpotFalloff(const LightData& light, const V3f& direction) {
  // Unlike the arc cosine this keeps its precision near the axis.
  const float angle = std::atan2(light.direction.cross(direction).length(),
                                 light.direction.dot(direction));
  if (angle <= light.cone) return 1;
  const float past = angle - light.cone;
  if (!(past < light.penumbra)) return 0;
  const float s = past / light.penumbra;
  return 1 - s * s * (3 - 2 * s);
}

/// A spot light from `position`.
RTB_HD inline LightSample SampleSpotLight(const LightData& light,
                                          const V3f& position) {
  LightSample sample = SamplePointLight(light, position);
  const float share = SpotFalloff(light, -sample.direction);
  if (!(share > 0)) return {};
  sample.irradiance *= share;
  return sample;
}

}  // namespace rtb
