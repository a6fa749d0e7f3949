/// @file
/// The BSDF of every material: its value, its sampling and the density of the
/// sampling, host and device. bsdf_data.h says in which frame. Phong is no
/// BSDF (phong.h): all three answer black for it, as for emitters.
#pragma once

#include <cmath>

#include "core/base/host_device.h"
#include "core/math/sin_cos.h"
#include "core/math/vec.h"
#include "core/shading/bsdf_data.h"
#include "core/shading/bsdf_delta.h"
#include "core/shading/bsdf_glossy.h"
#include "core/shading/ggx_energy.h"
#include "core/shading/plastic.h"

namespace rtb {

/// f of what lies below any gloss: Lambertian, plastic's base and the albedo
/// of Phong; 0 for other models and from below.
RTB_HD inline Rgb EvalDiffuse(const BsdfData& bsdf, const V3f& wo,
                              const V3f& wi) {
  if (!(wo.z > 0) || !(wi.z > 0)) return Rgb(0);
  switch (bsdf.model) {
    case SurfaceModel::kLambertian:
    case SurfaceModel::kPhong:
      return bsdf.color / kPi;
    case SurfaceModel::kPlastic:
      return EvalPlasticBase(bsdf, wo, wi);
    case SurfaceModel::kMirror:
    case SurfaceModel::kMetal:
    case SurfaceModel::kDielectric:
    case SurfaceModel::kEmissive:
      return Rgb(0);
  }
  return Rgb(0);
}

/// f per steradian, without the cosine and without delta parts.
RTB_HD inline Rgb EvalBsdf(const BsdfData& bsdf, const GgxEnergyView& energy,
                           const V3f& wo, const V3f& wi) {
  if (!HasNonDelta(bsdf)) return Rgb(0);
  return EvalDiffuse(bsdf, wo, wi) + EvalGlossy(bsdf, energy, wo, wi);
}

/// The chance that SampleBsdf draws from the specular part, not the diffuse
/// one: about its share of the albedo.
RTB_HD inline float SpecularChance(const BsdfData& bsdf, const V3f& wo) {
  if (bsdf.model == SurfaceModel::kLambertian) return 0;
  if (bsdf.model != SurfaceModel::kPlastic) return 1;
  const float through = PlasticTransmittance(bsdf, wo.z);
  // Rough facets are met at other angles too.
  const float mean = bsdf.alpha > 0 ? bsdf.average_fresnel : 0.0f;
  const float specular = 1 - through > mean ? 1 - through : mean;
  const float base =
      MaxComponent(PlasticBaseGain(bsdf)) * (1 - bsdf.average_fresnel);
  const float sum = specular + through * base;
  return sum > 0 ? specular / sum : 1.0f;
}

/// Density per solid angle with which SampleBsdf draws a non-delta `wi`. It
/// integrates to 1 less the chance of a delta sample and of a GGX sample that
/// goes below the surface.
RTB_HD inline float PdfBsdf(const BsdfData& bsdf, const GgxEnergyView& energy,
                            const V3f& wo, const V3f& wi) {
  if (!HasNonDelta(bsdf) || !(wo.z > 0) || !(wi.z > 0)) return 0;
  const float specular = SpecularChance(bsdf, wo);
  return specular * PdfGlossy(bsdf, energy, wo, wi) +
         (1 - specular) * wi.z / kPi;
}

/// The non-delta part's sample for a direction that was drawn.
RTB_HD inline BsdfSample SampleOf(const BsdfData& bsdf,
                                  const GgxEnergyView& energy, const V3f& wo,
                                  const V3f& wi) {
  BsdfSample sample;
  sample.wi = wi;
  sample.pdf = PdfBsdf(bsdf, energy, wo, wi);
  if (sample.pdf > 0) {
    sample.weight = EvalBsdf(bsdf, energy, wo, wi) * (wi.z / sample.pdf);
  }
  return sample;
}

/// Cosine-weighted direction above the surface: Malley's method.
RTB_HD inline V3f SampleCosine(const V2f& u) {
  const float radius = std::sqrt(u.x);
  const SineCosine phi = SinCosOf(2 * kPi * u.y);
  return V3f(radius * phi.cosine, radius * phi.sine, std::sqrt(1 - u.x));
}

/// Draws wi. A black weight ends the path.
/// @param u uniforms in [0, 1); z chooses the lobe.
RTB_HD inline BsdfSample SampleBsdf(const BsdfData& bsdf,
                                    const GgxEnergyView& energy, const V3f& wo,
                                    const V3f& u) {
  if (bsdf.model == SurfaceModel::kDielectric) {
    return SampleDielectric(bsdf, wo, u.z);
  }
  if (!(wo.z > 0)) return BsdfSample{};
  if (bsdf.model == SurfaceModel::kMirror) return MirrorSample(wo, bsdf.color);
  if (!HasDelta(bsdf) && !HasNonDelta(bsdf)) return BsdfSample{};
  const float specular = SpecularChance(bsdf, wo);
  if (u.z >= specular) {
    return SampleOf(bsdf, energy, wo, SampleCosine(V2f(u.x, u.y)));
  }
  if (bsdf.alpha == 0) {
    return MirrorSample(wo, SpecularFresnel(bsdf, wo.z) / specular);
  }
  return SampleOf(bsdf, energy, wo,
                  GlossyDirection(bsdf, energy, wo, V2f(u.x, u.y)));
}

}  // namespace rtb
