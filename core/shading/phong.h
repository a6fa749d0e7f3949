/// @file
/// Phong's highlight, which the Whitted integrator alone knows, host and
/// device.
#pragma once

#include <cmath>

#include "core/base/host_device.h"
#include "core/math/vec.h"
#include "core/shading/bsdf_data.h"
#include "core/shading/microfacet.h"

namespace rtb {

/// The highlight's radiance per irradiance that the light gives on a surface
/// facing it (no cosine): specular max(0, R.L)^exponent / pi, R the mirror
/// direction of the viewer. Phong, "Illumination for Computer Generated
/// Pictures", CACM 18(6), 1975; 0 where the light is behind the surface. The
/// albedo's part is EvalDiffuse.
RTB_HD inline Rgb EvalPhong(const BsdfData& bsdf, const V3f& wo,
                            const V3f& wi) {
  if (!(wo.z > 0) || !(wi.z > 0)) return Rgb(0);
  const float cosine = wo.z * wi.z - wo.x * wi.x - wo.y * wi.y;
  if (!(cosine > 0)) return Rgb(0);
  return bsdf.specular * (std::pow(cosine, bsdf.exponent) / kPi);
}

}  // namespace rtb
