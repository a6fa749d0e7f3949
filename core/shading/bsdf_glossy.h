/// @file
/// The GGX lobe of rough metal and rough plastic with its compensation for
/// multiple scattering, host and device. Metal has Schlick's Fresnel, plastic
/// the dielectric's.
#pragma once

#include "core/base/host_device.h"
#include "core/math/vec.h"
#include "core/shading/bsdf_data.h"
#include "core/shading/fresnel.h"
#include "core/shading/ggx_energy.h"
#include "core/shading/microfacet.h"

namespace rtb {

/// Fresnel reflectance of the material's interface from outside.
RTB_HD inline Rgb SpecularFresnel(const BsdfData& bsdf, float cosine) {
  if (bsdf.model == SurfaceModel::kMetal) {
    return FresnelSchlick(bsdf.color, cosine);
  }
  return Rgb(FresnelDielectric(cosine, 1 / bsdf.ior));
}

/// Its cosine-weighted mean; Schlick's is F0 + (1 - F0) / 21.
RTB_HD inline Rgb MeanSpecularFresnel(const BsdfData& bsdf) {
  if (bsdf.model == SurfaceModel::kMetal) {
    return bsdf.color * (20.0f / 21) + Rgb(1.0f / 21);
  }
  return Rgb(bsdf.average_fresnel);
}

/// What the facets reflect more than once as a share of what they would if
/// they were white. With F and E the mean Fresnel and albedo, light leaves
/// after the first bounce with F E, and after bounce k + 1 with
/// F E (F (1 - E))^k; the sum over k >= 1 over 1 - E is
///   F^2 E / (1 - F (1 - E)),
/// 1 for F = 1 (Kulla and Conty 2017, "Metallic Fresnel", where one F less is
/// printed than the sum has).
RTB_HD inline Rgb MultipleFresnel(const BsdfData& bsdf) {
  const Rgb f = MeanSpecularFresnel(bsdf);
  return f * f * (1 - bsdf.average_loss) / (Rgb(1) - f * bsdf.average_loss);
}

/// f of the whole lobe; 0 for smooth surfaces and from below.
RTB_HD inline Rgb EvalGlossy(const BsdfData& bsdf, const GgxEnergyView& energy,
                             const V3f& wo, const V3f& wi) {
  if (!IsGlossy(bsdf) || !(wo.z > 0) || !(wi.z > 0)) return Rgb(0);
  const V3f h = (wo + wi).normalized();
  const Rgb single =
      SpecularFresnel(bsdf, wo.dot(h)) *
      (GgxDistribution(h, bsdf.alpha) * GgxVisibility(wo, wi, bsdf.alpha));
  const float loss = GgxLoss(energy, wo.z, bsdf.alpha) *
                     GgxLoss(energy, wi.z, bsdf.alpha) /
                     (kPi * bsdf.average_loss);
  return single + MultipleFresnel(bsdf) * loss;
}

/// The chance that SampleGlossy draws a single reflection, not compensation:
/// the share of the two in the albedo, but for what they have in common.
RTB_HD inline float SingleChance(const BsdfData& bsdf,
                                 const GgxEnergyView& energy, const V3f& wo) {
  const float loss = GgxLoss(energy, wo.z, bsdf.alpha);
  const Rgb f = MeanSpecularFresnel(bsdf);
  const float f_max =
      f.x > f.y ? (f.x > f.z ? f.x : f.z) : (f.y > f.z ? f.y : f.z);
  const float more =
      f_max * (1 - bsdf.average_loss) / (1 - f_max * bsdf.average_loss);
  return (1 - loss) / (1 - loss + loss * more);
}

/// Density per solid angle of SampleGlossy's directions. It integrates to 1
/// less the share of single reflections that go below the surface.
RTB_HD inline float PdfGlossy(const BsdfData& bsdf, const GgxEnergyView& energy,
                              const V3f& wo, const V3f& wi) {
  if (!IsGlossy(bsdf) || !(wo.z > 0) || !(wi.z > 0)) return 0;
  const V3f h = (wo + wi).normalized();
  const float single = SingleChance(bsdf, energy, wo);
  return single * VisibleReflectionPdf(wo, h, bsdf.alpha) +
         (1 - single) * wi.z / kPi;
}

/// Cosine-weighted direction above the surface: Malley's method.
RTB_HD inline V3f SampleCosine(const V2f& u) {
  const float radius = std::sqrt(u.x);
  const float phi = 2 * kPi * u.y;
  return V3f(radius * std::cos(phi), radius * std::sin(phi),
             std::sqrt(1 - u.x));
}

/// Maps two uniforms to a direction of the lobe, never to a value outside the
/// unit hemisphere; black where wi would be below it. Neighboring uniforms
/// give neighboring directions but for one step in u.x, so that stratified
/// uniforms give stratified rays.
RTB_HD inline V3f GlossyDirection(const BsdfData& bsdf,
                                  const GgxEnergyView& energy, const V3f& wo,
                                  const V2f& u) {
  const float single = SingleChance(bsdf, energy, wo);
  if (u.x >= single) {
    return SampleCosine(V2f(u.y, (u.x - single) / (1 - single)));
  }
  const V3f h = SampleVisibleNormal(wo, bsdf.alpha, V2f(u.x / single, u.y));
  return (h * (2 * wo.dot(h)) - wo).normalized();
}

/// A direction of the GGX lobe alone with its weight f cos / pdf; black, with
/// pdf 0, where the facets mirror the view below the surface.
RTB_HD inline BsdfSample SampleGlossy(const BsdfData& bsdf,
                                      const GgxEnergyView& energy,
                                      const V3f& wo, const V2f& u) {
  BsdfSample sample;
  if (!IsGlossy(bsdf) || !(wo.z > 0)) return sample;
  sample.wi = GlossyDirection(bsdf, energy, wo, u);
  const float pdf = PdfGlossy(bsdf, energy, wo, sample.wi);
  if (!(pdf > 0)) return sample;
  sample.pdf = pdf;
  sample.weight = EvalGlossy(bsdf, energy, wo, sample.wi) * (sample.wi.z / pdf);
  return sample;
}

}  // namespace rtb
