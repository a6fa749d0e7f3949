/// @file
/// Plastic's diffuse base under its dielectric coat, host and device.
#pragma once

#include "core/base/host_device.h"
#include "core/shading/bsdf_data.h"
#include "core/shading/fresnel.h"
#include "core/shading/microfacet.h"

namespace rtb {

/// The cosine-weighted mean of the Fresnel reflectance over the directions of
/// one side, by float64 quadrature: 2 int F(cos) cos d(cos), seen from outside
/// an interface of index `ior` >= 1. From inside it is 1 - (1 - this) / ior^2.
double AverageFresnel(double ior);

/// The reflectance of the base for light that crosses the coat both ways, but
/// for the coat's transmittances T(i) and T(o): the share `color` of each
/// meeting with the base, summed over the internal reflections R,
///   color / (ior^2 (1 - R color)), 1 - R = (1 - average_fresnel) / ior^2,
/// where 1 / ior^2 is what the radiance loses in leaving the denser side
/// (Pharr, Jakob and Humphreys, "Physically Based Rendering", 4th ed., 9.5.2 on
/// refracted radiance). It is 1 / (1 - average_fresnel) for color 1, so
/// that a white base returns what it gets.
RTB_HD inline Rgb PlasticBaseGain(const BsdfData& bsdf) {
  const Rgb& a = bsdf.color;
  const float n2 = bsdf.ior * bsdf.ior;
  return a / ((Rgb(1) - a) * n2 + a * (1 - bsdf.average_fresnel));
}

/// The coat's transmittance in a direction with that cosine outside.
RTB_HD inline float PlasticTransmittance(const BsdfData& bsdf, float cosine) {
  return 1 - FresnelDielectric(cosine, 1 / bsdf.ior);
}

/// f of the base; both directions are above the surface.
RTB_HD inline Rgb EvalPlasticBase(const BsdfData& bsdf, const V3f& wo,
                                  const V3f& wi) {
  return PlasticBaseGain(bsdf) * (PlasticTransmittance(bsdf, wo.z) *
                                  PlasticTransmittance(bsdf, wi.z) / kPi);
}

}  // namespace rtb
