/// @file
/// Lights as plain data for host and device. light_make.h builds them,
/// light.h samples them.
#pragma once

#include <limits>

#include "core/base/host_device.h"
#include "core/math/vec.h"

namespace rtb {

/// What a light is. kTriangle is a triangle of an emissive object.
enum class LightModel {
  kPoint,
  kDirectional,
  kSpot,
  kQuad,
  kSphere,
  kTriangle
};

/// A light; the members that a model has no use for are at rest.
struct LightData {
  LightModel model = LightModel::kPoint;
  V3f position{0};   ///< Point, spot; a quad's or triangle's corner, a
                     ///< sphere's center.
  V3f direction{0};  ///< Unit: the direction of travel of a directional light,
                     ///< a spot's axis, a quad's or triangle's normal along
                     ///< edge0 x edge1.
  Rgb color{0};      ///< Intensity (point, spot), irradiance (directional),
                     ///< else radiance.
  bool inverse_square = true;  ///< Point lights.
  int samples = 1;             ///< Rays that Whitted spends on it.
  float cone = 0;              ///< Spot: half angle of full intensity, radians.
  float penumbra = 0;          ///< Spot: radians over which it falls to 0.
  V3f edge0{0};                ///< Quad, triangle: edges from `position`.
  V3f edge1{0};
  float area = 0;          ///< Quad, triangle.
  bool rectangle = false;  ///< Quad: the edges are perpendicular.
  float radius = 0;        ///< Sphere.
};

/// How a light is seen from a point. All is zero where it sends no light.
struct LightSample {
  V3f direction{0};    ///< Unit, towards the light.
  float distance = 0;  ///< To the light's surface; infinite for directional
                       ///< lights. A shadow ray that may meet the light's own
                       ///< surface must end short of it.
  Rgb irradiance{0};   ///< On a surface that faces the light, unshadowed: of a
                       ///< light with extent the estimate radiance / pdf.
  float pdf = 0;       ///< Per solid angle; 0 for lights without extent.
};

/// Whether BSDF rays can hit the light: point, directional and spot lights
/// have no extent.
RTB_HD inline bool HasExtent(const LightData& light) {
  return light.model == LightModel::kQuad ||
         light.model == LightModel::kSphere ||
         light.model == LightModel::kTriangle;
}

/// Whether a density can be divided by.
RTB_HD inline bool IsUsableDensity(float pdf) {
  return pdf >= std::numeric_limits<float>::min() &&
         pdf <= std::numeric_limits<float>::max();
}

}  // namespace rtb
