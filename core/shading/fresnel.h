/// @file
/// Fresnel reflectance and refraction, host and device.
#pragma once

#include <cmath>

#include "core/base/host_device.h"
#include "core/math/vec.h"

namespace rtb {

/// Unpolarized Fresnel reflectance of a smooth dielectric interface: the mean
/// of the s and p reflectances (Born and Wolf, Principles of Optics, 1.5.2).
/// @param cos_i cosine of the angle of incidence, 0..1.
/// @param eta index on the incident side / index on the other side.
/// @return 1 under total internal reflection.
template <class T>
RTB_HD T DielectricReflectance(T cos_i, T eta) {
  const T sin2_t = eta * eta * (1 - cos_i * cos_i);
  if (sin2_t >= 1) return 1;
  const T cos_t = std::sqrt(1 - sin2_t);
  const T s = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
  const T p = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
  return (s * s + p * p) / 2;
}

/// DielectricReflectance in rendering's precision.
RTB_HD inline float FresnelDielectric(float cos_i, float eta) {
  return DielectricReflectance(cos_i, eta);
}

/// Schlick, "An Inexpensive BRDF Model for Physically-based Rendering", 1994,
/// equation 15: F0 + (1 - F0) (1 - cos)^5.
RTB_HD inline Rgb FresnelSchlick(const Rgb& f0, float cos_i) {
  const float m = 1 - cos_i;
  const float m2 = m * m;
  return f0 + (Rgb(1) - f0) * (m2 * m2 * m);
}

/// Mirror direction of a unit direction d about a unit normal.
RTB_HD inline V3f Reflect(const V3f& d, const V3f& normal) {
  return (d - normal * (2 * d.dot(normal))).normalized();
}

/// Refracted direction after Snell's law.
/// @param d unit direction of travel; @param normal unit, against d.
/// @param eta index on the incident side / index on the other side; no total
/// internal reflection may occur.
RTB_HD inline V3f Refract(const V3f& d, const V3f& normal, float eta) {
  const float cos_i = -d.dot(normal);
  const float sin2_t = eta * eta * (1 - cos_i * cos_i);
  const float cos_t = std::sqrt(sin2_t < 1 ? 1 - sin2_t : 0.0f);
  return (d * eta + normal * (eta * cos_i - cos_t)).normalized();
}

}  // namespace rtb
