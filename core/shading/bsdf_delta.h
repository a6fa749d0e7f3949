/// @file
/// Reflection and refraction in one direction as samples of a BSDF, host and
/// device.
#pragma once

#include "core/base/host_device.h"
#include "core/math/vec.h"
#include "core/shading/bsdf_data.h"
#include "core/shading/fresnel.h"

namespace rtb {

/// The mirror direction with that weight.
RTB_HD inline BsdfSample MirrorSample(const V3f& wo, const Rgb& weight) {
  BsdfSample sample;
  sample.wi = V3f(-wo.x, -wo.y, wo.z);
  sample.weight = weight;
  sample.delta = true;
  return sample;
}

/// A smooth dielectric reflects with the chance of its reflectance and else
/// transmits; radiance is not scaled by the indices.
/// @param u uniform.
RTB_HD inline BsdfSample SampleDielectric(const BsdfData& bsdf, const V3f& wo,
                                          float u) {
  const bool outside = wo.z > 0;
  const float eta = outside ? 1 / bsdf.ior : bsdf.ior;
  const float cosine = outside ? wo.z : -wo.z;
  if (u < FresnelDielectric(cosine, eta)) return MirrorSample(wo, Rgb(1));
  BsdfSample sample;
  sample.wi = Refract(-wo, V3f(0, 0, outside ? 1.0f : -1.0f), eta);
  sample.weight = bsdf.color;
  sample.delta = true;
  sample.transmitted = true;
  return sample;
}

}  // namespace rtb
