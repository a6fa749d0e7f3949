/// @file
/// The GGX lobe of rough metal and rough plastic with its compensation for
/// multiple scattering, host and device. Metal has Schlick's Fresnel, plastic
/// the dielectric's.
#pragma once

#include <cmath>

#include "core/base/host_device.h"
#include "core/math/sin_cos.h"
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

/// The share of what facets reflect once that leaves after further bounces,
/// for each unit of the loss 1 - E. With F and E the mean Fresnel and albedo,
/// bounce k + 1 lets go F E (F (1 - E))^k; the sum over k >= 1 is
/// F (1 - E) * F E / (1 - F (1 - E)).
/// @return F E / (1 - F (1 - E)): 1 for F = 1.
RTB_HD inline Rgb FurtherShare(const BsdfData& bsdf) {
  const Rgb f = MeanSpecularFresnel(bsdf);
  return f * (1 - bsdf.average_loss) / (Rgb(1) - f * bsdf.average_loss);
}

/// f of the compensation lobe, reciprocal and of the albedo that is lost:
/// Kulla and Conty 2017. Its Fresnel term F^2 E / (1 - F (1 - E)) has one F
/// more than their slides print, as the sum above has.
RTB_HD inline Rgb EvalCompensation(const BsdfData& bsdf,
                                   const GgxEnergyView& energy, float cos_o,
                                   float cos_i) {
  const float loss = GgxLoss(energy, cos_o, bsdf.alpha) *
                     GgxLoss(energy, cos_i, bsdf.alpha) /
                     (kPi * bsdf.average_loss);
  return MeanSpecularFresnel(bsdf) * FurtherShare(bsdf) * loss;
}

/// f of the whole lobe; 0 for smooth surfaces and from below.
RTB_HD inline Rgb EvalGlossy(const BsdfData& bsdf, const GgxEnergyView& energy,
                             const V3f& wo, const V3f& wi) {
  if (!IsGlossy(bsdf) || !(wo.z > 0) || !(wi.z > 0)) return Rgb(0);
  const V3f h = (wo + wi).normalized();
  const Rgb single =
      SpecularFresnel(bsdf, wo.dot(h)) *
      (GgxDistribution(h, bsdf.alpha) * GgxVisibility(wo, wi, bsdf.alpha));
  return single + EvalCompensation(bsdf, energy, wo.z, wi.z);
}

/// Maps two uniforms to a direction of the compensation lobe. Its loss times
/// cosine falls as 1 / cos above cos = alpha: for narrow lobes most of it is
/// grazing, where a cosine-weighted choice would hardly ever look. So
/// w = log(1 + cos / alpha) / log(1 + 1 / alpha) is drawn with density 2 w.
RTB_HD inline V3f SampleCompensation(float alpha, const V2f& u) {
  const float range = std::log1p(1 / alpha);
  const float cosine = alpha * std::expm1(std::sqrt(u.x) * range);
  const float z = cosine < 1 ? cosine : 1.0f;
  const float radius = std::sqrt(1 - z * z);
  const SineCosine phi = SinCosOf(2 * kPi * u.y);
  return V3f(radius * phi.cosine, radius * phi.sine, z);
}

/// Its density per solid angle.
RTB_HD inline float CompensationPdf(float alpha, float cosine) {
  const float range = std::log1p(1 / alpha);
  return std::log1p(cosine / alpha) / (range * range * kPi * (cosine + alpha));
}

/// The chance that SampleGlossy draws a single reflection, not compensation:
/// the share of the two in the albedo, but for what they have in common.
RTB_HD inline float SingleChance(const BsdfData& bsdf,
                                 const GgxEnergyView& energy, const V3f& wo) {
  const float loss = GgxLoss(energy, wo.z, bsdf.alpha);
  return (1 - loss) / (1 - loss + loss * MaxComponent(FurtherShare(bsdf)));
}

/// Density per solid angle of SampleGlossy's directions. It integrates to 1
/// less the share of single reflections that go below the surface.
RTB_HD inline float PdfGlossy(const BsdfData& bsdf, const GgxEnergyView& energy,
                              const V3f& wo, const V3f& wi) {
  if (!IsGlossy(bsdf) || !(wo.z > 0) || !(wi.z > 0)) return 0;
  const V3f h = (wo + wi).normalized();
  const float single = SingleChance(bsdf, energy, wo);
  return single * VisibleReflectionPdf(wo, h, bsdf.alpha) +
         (1 - single) * CompensationPdf(bsdf.alpha, wi.z);
}

/// Maps two uniforms to a direction of the lobe, which may lie below the
/// surface. Near uniforms give near directions but for one step in u.x, so
/// that stratified uniforms give stratified rays.
RTB_HD inline V3f GlossyDirection(const BsdfData& bsdf,
                                  const GgxEnergyView& energy, const V3f& wo,
                                  const V2f& u) {
  const float single = SingleChance(bsdf, energy, wo);
  if (u.x >= single) {
    return SampleCompensation(bsdf.alpha,
                              V2f(u.y, (u.x - single) / (1 - single)));
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
