/// @file
/// Sphere lights, sampled uniformly over the cone of directions that they
/// subtend: Shirley, Wang and Zimmerman, "Monte Carlo Techniques for Direct
/// Lighting Calculations", ACM TOG 15(1), 1996, spherical luminaires.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/host_device.h"
#include "core/math/frame.h"
#include "core/math/sin_cos.h"
#include "core/shading/light_data.h"

namespace rtb {

/// A sphere light as seen from a point.
struct SphereCone {
  float distance = 0;  ///< To the center.
  float sine = 0;      ///< Of the cone's half angle.
  float height = 0;    ///< 1 - cosine of the half angle; 0 from within.

  /// In steradians: 2 pi * height.
  RTB_HD float SolidAngle() const {
    return 2 * std::numbers::pi_v<float> * height;
  }
};

/// The cone of a sphere light, precise from the surface to any distance.
RTB_HD inline SphereCone ConeOf(const LightData& sphere, const V3f& position) {
  const float distance = (sphere.position - position).length();
  const float sine = sphere.radius / distance;
  if (!(sine <= 1)) return {distance, 1, 0};
  // 1 - cos = sin^2 / (1 + cos) cancels nothing.
  const float cosine = std::sqrt((1 - sine) * (1 + sine));
  return {distance, sine, sine * sine / (1 + cosine)};
}

/// Density per solid angle, of every direction that hits the sphere; 0 inside.
RTB_HD inline float SphereLightPdf(const LightData& sphere,
                                   const V3f& position) {
  const float pdf = 1 / ConeOf(sphere, position).SolidAngle();
  return IsUsableDensity(pdf) ? pdf : 0;
}

/// A sphere light from `position`; black from inside.
RTB_HD inline LightSample SampleSphereLight(const LightData& sphere,
                                            const V3f& position, const V2f& u) {
  const SphereCone cone = ConeOf(sphere, position);
  const float pdf = 1 / cone.SolidAngle();
  if (!IsUsableDensity(pdf)) return {};
  const V3f axis = (sphere.position - position) / cone.distance;
  const Tangents<float> frame = TangentsOf(axis);
  const float height = u.x * cone.height;
  const float sin2 = height * (2 - height);
  const SineCosine phi = SinCosOf(2 * std::numbers::pi_v<float> * u.y);
  const V3f side = frame.s * phi.cosine + frame.t * phi.sine;
  const V3f direction = axis * (1 - height) + side * std::sqrt(sin2);
  // Half the chord inside the sphere: r sqrt(1 - (sin / sin of the rim)^2).
  const float rim = sin2 / (cone.sine * cone.sine);
  const float chord = sphere.radius * std::sqrt(std::max(0.0f, 1 - rim));
  const float distance = cone.distance * (1 - height) - chord;
  return {direction.normalized(), std::max(0.0f, distance),
          sphere.color * cone.SolidAngle(), pdf};
}

}  // namespace rtb
