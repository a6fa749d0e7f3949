/// @file
/// Lights without extent as plain data for host and device.
#pragma once

#include <cmath>
#include <limits>

#include "core/base/host_device.h"
#include "core/math/vec.h"

namespace rtb {

enum class LightModel { kPoint, kDirectional };

/// A point or directional light.
struct LightData {
  LightModel model = LightModel::kPoint;
  V3f position{0};   ///< Point lights.
  V3f direction{0};  ///< Directional lights: unit direction of travel.
  Rgb color{0};      ///< Intensity, or irradiance.
  bool inverse_square = true;
};

/// How a light is seen from a point.
struct LightSample {
  V3f direction{0};    ///< Unit, towards the light.
  float distance = 0;  ///< Infinite for directional lights.
  Rgb irradiance{0};   ///< On a surface that faces the light, unshadowed.
};

/// The light as seen from `position`; zero irradiance at the light itself.
RTB_HD inline LightSample SampleLight(const LightData& light,
                                      const V3f& position) {
  if (light.model == LightModel::kDirectional) {
    return {-light.direction, std::numeric_limits<float>::infinity(),
            light.color};
  }
  const V3f to_light = light.position - position;
  const float distance = to_light.length();
  if (!(distance > 0)) return {};
  const Rgb irradiance =
      light.inverse_square ? light.color / distance / distance : light.color;
  return {to_light / distance, distance, irradiance};
}

}  // namespace rtb
