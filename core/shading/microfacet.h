/// @file
/// The GGX microfacet distribution in the local frame of a surface (+z is the
/// normal), host and device. Nothing here divides by a cosine or by alpha^2 in
/// a way that loses digits, so alphas down to kSmoothestAlpha are safe.
///
/// `w` stands for a unit direction above the surface, `h` for a unit
/// microfacet normal with h.z > 0, `alpha` for GGX's width, 0 < alpha <= 1.
#pragma once

#include <cmath>

#include "core/base/host_device.h"
#include "core/math/constants.h"
#include "core/math/sin_cos.h"
#include "core/math/vec.h"

namespace rtb {

/// Density of microfacet normals, per solid angle and projected area: Walter
/// et al., "Microfacet Models for Refraction through Rough Surfaces", EGSR
/// 2007, equation 33, with the tangent written out.
RTB_HD inline float GgxDistribution(const V3f& h, float alpha) {
  const float x = h.x / alpha;
  const float y = h.y / alpha;
  const float t = x * x + y * y + h.z * h.z;
  return 1 / (kPi * (alpha * t) * (alpha * t));
}

/// sqrt(cos^2 + alpha^2 sin^2): the part that Smith's functions share.
RTB_HD inline float GgxStretchedLength(const V3f& w, float alpha) {
  return std::sqrt(w.z * w.z + alpha * alpha * (w.x * w.x + w.y * w.y));
}

/// Height-correlated Smith masking-shadowing / (4 cos_o cos_i): Heitz,
/// "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs",
/// JCGT 3(2), 2014, equation 99, multiplied out.
RTB_HD inline float GgxVisibility(const V3f& wo, const V3f& wi, float alpha) {
  return 0.5f / (wi.z * GgxStretchedLength(wo, alpha) +
                 wo.z * GgxStretchedLength(wi, alpha));
}

/// Maps two uniforms to a microfacet normal as seen from `wo`: Heitz,
/// "Sampling the GGX Distribution of Visible Normals", JCGT 7(4), 2018, where
/// the visible normals of the stretched hemisphere are the half vectors of a
/// spherical cap (Dupuy and Benyoub, "Sampling Visible GGX Normals with
/// Spherical Caps", HPG 2023, section 3).
RTB_HD inline V3f SampleVisibleNormal(const V3f& wo, float alpha,
                                      const V2f& u) {
  const V3f stretched = V3f(alpha * wo.x, alpha * wo.y, wo.z).normalized();
  const float z = (1 - u.y) * (1 + stretched.z) - stretched.z;
  const float radius = std::sqrt(z * z < 1 ? 1 - z * z : 0.0f);
  const SineCosine phi = SinCosOf(2 * kPi * u.x);
  const V3f sum = V3f(radius * phi.cosine, radius * phi.sine, z) + stretched;
  return V3f(alpha * sum.x, alpha * sum.y, sum.z).normalized();
}

/// Density per solid angle of the directions that mirror `wo` about normals
/// of SampleVisibleNormal: Heitz 2018, equations 3 and 17. Over the upper
/// hemisphere it integrates to less than 1: the rest is mirrored below.
RTB_HD inline float VisibleReflectionPdf(const V3f& wo, const V3f& h,
                                         float alpha) {
  return GgxDistribution(h, alpha) /
         (2 * (wo.z + GgxStretchedLength(wo, alpha)));
}

}  // namespace rtb
