/// @file
/// Lights for tests, and what they add up to.
#pragma once

#include <cmath>
#include <numbers>

#include "core/shading/light.h"
#include "core/shading/light_make.h"

namespace rtb {

inline constexpr double kPiExact = std::numbers::pi;

inline LightData MakeQuad(const V3d& corner, const V3d& e0, const V3d& e1,
                          const Rgb& radiance) {
  return ToLightData({"", QuadLight{corner, {e0, e1}, radiance, 1}, kNone, {}},
                     V3d(0));
}

inline LightData MakeSphere(const V3d& center, double radius,
                            const Rgb& radiance) {
  return ToLightData({"", SphereLight{center, radius, radiance, 1}, kNone, {}},
                     V3d(0));
}

/// Mean over the centers of n x n squares of u of a function of u.
template <class F>
double MeanOverSquare(int n, F f) {
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      sum += f(V2f((static_cast<float>(i) + 0.5f) / static_cast<float>(n),
                   (static_cast<float>(j) + 0.5f) / static_cast<float>(n)));
    }
  }
  return sum / n / n;
}

/// What a sample adds to the irradiance of a surface.
inline double CosineWeighted(const LightSample& sample, const V3f& normal) {
  const double cosine = sample.direction.dot(normal);
  return cosine > 0 ? sample.irradiance.x * cosine : 0;
}

/// Irradiance by n x n stratified samples of SampleLight.
inline double Irradiance(const LightData& light, const V3f& position,
                         const V3f& normal, int n) {
  return MeanOverSquare(n, [&](const V2f& u) {
    return CosineWeighted(SampleLight(light, position, u), normal);
  });
}

/// Lambert, "Photometria", 1760: the irradiance of a polygon that lies above
/// the horizon, radiance / 2 * sum of (angle of edge) * (unit normal of the
/// edge's plane through the point) . n. Counter-clockwise as seen from there.
template <class Vertices>
double PolygonIrradiance(const Vertices& vertices, const V3d& position,
                         const V3d& normal) {
  double sum = 0;
  const std::size_t count = vertices.size();
  for (std::size_t i = 0; i < count; ++i) {
    const V3d a = (vertices[i] - position).normalized();
    const V3d b = (vertices[(i + 1) % count] - position).normalized();
    const V3d c = a.cross(b);
    sum += std::atan2(c.length(), a.dot(b)) * c.normalized().dot(normal);
  }
  return sum / 2;
}

/// Integral over all directions, by the centers of n x 2n cells that are equal
/// in solid angle; the cells are widest around +-x.
template <class F>
double IntegralOverSphere(int n, F f) {
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    const double x = 1 - (2 * i + 1.0) / n;
    const double sine = std::sqrt(1 - x * x);
    for (int j = 0; j < 2 * n; ++j) {
      const double phi = kPiExact * (j + 0.5) / n;
      sum += f(V3f(V3d(x, sine * std::cos(phi), sine * std::sin(phi))));
    }
  }
  return sum * 2 * kPiExact / n / n;
}

}  // namespace rtb
