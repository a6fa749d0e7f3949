/// @file
/// Rectangular quad lights, sampled uniformly over the solid angle that they
/// subtend: Urena, Fajardo and King, "An Area-Preserving Parametrization for
/// Spherical Rectangles", Computer Graphics Forum 32(4), 2013.
///
/// The paper's inverse cosines lose digits at grazing angles. Here the same
/// map is written with the solid angle of a corner rectangle,
/// A(x, y) = atan(x y / (|z| sqrt(x^2 + y^2 + z^2))), in place of the dihedral
/// angles, which are pi/2 -+ A.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/base/host_device.h"
#include "core/math/sin_cos.h"
#include "core/shading/light_data.h"

namespace rtb {

/// A rectangle in the frame of its edges around a viewer: it spans
/// [x0, x1] x [y0, y1] at height z0, which is negative in front of it.
struct SphericalRectangle {
  V3f x, y, z;
  float x0 = 0, x1 = 0, y0 = 0, y1 = 0, z0 = 0;
  float a00 = 0, a01 = 0;  ///< Corner angles A(x0, y0) and A(x0, y1).
  float solid_angle = 0;   ///< Steradians; 0 in its plane and behind.
};

/// A(x, y) at height z, signed.
RTB_HD inline float CornerAngle(float x, float y, float z) {
  return std::atan2(x * y, std::abs(z) * std::sqrt(x * x + y * y + z * z));
}

/// A rectangular quad light as seen from a point.
RTB_HD inline SphericalRectangle SeenFrom(const LightData& light,
                                          const V3f& position) {
  const float width = light.edge0.length();
  const float height = light.edge1.length();
  const V3f corner = light.position - position;
  SphericalRectangle r{light.edge0 / width, light.edge1 / height,
                       light.direction};
  r.z0 = corner.dot(r.z);
  if (!(r.z0 < 0)) return r;
  r.x0 = corner.dot(r.x);
  r.x1 = r.x0 + width;
  r.y0 = corner.dot(r.y);
  r.y1 = r.y0 + height;
  r.a00 = CornerAngle(r.x0, r.y0, r.z0);
  r.a01 = CornerAngle(r.x0, r.y1, r.z0);
  r.solid_angle = CornerAngle(r.x1, r.y1, r.z0) - r.a01 -
                  CornerAngle(r.x1, r.y0, r.z0) + r.a00;
  return r;
}

/// Whether the rectangle is large enough for its solid angle, a difference of
/// angles, to be precise: to 3e-5 from here on. Smaller ones are sampled by
/// area, which is about as good then.
RTB_HD inline bool IsWide(const SphericalRectangle& r) {
  return r.solid_angle >= 0.01f;
}

/// The abscissa left of which lies the share u of the solid angle.
RTB_HD inline float SampleX(const SphericalRectangle& r, float u) {
  // The strip [0, x] has angle a = asin(c1 s) - asin(c0 s), s = x/|(x, z)|,
  // c = y/|(y, z)|; s follows by the law of cosines.
  const float a = r.a01 - r.a00 + u * r.solid_angle;
  const float c0 = r.y0 / std::sqrt(r.y0 * r.y0 + r.z0 * r.z0);
  const float c1 = r.y1 / std::sqrt(r.y1 * r.y1 + r.z0 * r.z0);
  const bool same = c0 * c1 >= 0;  // then sums of what is not negative
  const SineCosine of_half = SinCosOf(a / 2);
  const float half = same ? of_half.sine : of_half.cosine;
  const float difference = same ? c1 - c0 : c1 + c0;
  const float side2 =
      difference * difference + 4 * std::abs(c0 * c1) * half * half;
  const float s = SinCosOf(a).sine / std::sqrt(side2);
  const float x = s * std::abs(r.z0) / std::sqrt(std::max(0.0f, 1 - s * s));
  return std::min(r.x1, std::max(r.x0, x));  // x0 where x is no number
}

/// The ordinate at abscissa x for the share v of the solid angle.
RTB_HD inline float SampleY(const SphericalRectangle& r, float x, float v) {
  const float d2 = x * x + r.z0 * r.z0;
  const float h0 = r.y0 / std::sqrt(d2 + r.y0 * r.y0);
  const float h1 = r.y1 / std::sqrt(d2 + r.y1 * r.y1);
  const float h = h0 + v * (h1 - h0);
  const float y = h * std::sqrt(d2) / std::sqrt(std::max(0.0f, 1 - h * h));
  return std::min(r.y1, std::max(r.y0, y));
}

/// A sample of a wide rectangle: the irradiance has no variance.
RTB_HD inline LightSample SampleRectangle(const LightData& light,
                                          const SphericalRectangle& r,
                                          const V2f& u) {
  const float x = SampleX(r, u.x);
  const float y = SampleY(r, x, u.y);
  const V3f to_light = r.x * x + r.y * y + r.z * r.z0;
  const float distance = to_light.length();
  return {to_light / distance, distance, light.color * r.solid_angle,
          1 / r.solid_angle};
}

}  // namespace rtb
