/// @file
/// What a BSDF needs of a material at one point, and a sample of it, as plain
/// data for host and device.
///
/// All directions of the BSDFs are unit, lead away from the surface, and are
/// given in its local frame, whose +z is the shading normal: turned to the
/// viewer, but the outward one for a dielectric, where wo.z < 0 says that the
/// viewer is inside. Opaque surfaces answer 0 from below.
#pragma once

#include "core/base/host_device.h"
#include "core/math/vec.h"
#include "core/shading/ggx_energy.h"
#include "core/shading/surface_model.h"

namespace rtb {

/// GGX lobes narrower than this are mirrors: float directions are too coarse
/// for them. It is roughness 0.003.
inline constexpr float kSmoothestAlpha = 1e-5f;

/// A BSDF's parameters; MakeBsdf fills in what is precomputed. `color` may be
/// replaced afterwards, by a texture's.
struct BsdfData {
  SurfaceModel model = SurfaceModel::kLambertian;
  Rgb color{0};      ///< Albedo, reflectance, tint, or F0, by model.
  float ior = 1.5f;  ///< Inside relative to outside; dielectric and plastic.
  float alpha = 0;   ///< GGX's width; 0 = smooth.
  float average_loss = 0;     ///< GgxAverageLoss of alpha.
  float average_fresnel = 0;  ///< AverageFresnel of ior.
  Rgb specular{0};            ///< Phong.
  float exponent = 1;         ///< Phong.
};

/// A direction drawn from a BSDF.
struct BsdfSample {
  V3f wi{0};
  Rgb weight{0};  ///< f |cos| / pdf; black where nothing was drawn.
  float pdf = 0;  ///< Of EvalBsdf's part per solid angle; 0 when delta.
  bool delta = false;
  bool transmitted = false;
};

/// A metal's, plastic's, or any other model's data. Not for the device.
/// @param roughness 0..1, of metal and plastic; alpha is its square.
/// @param ior 1..4, of dielectric and plastic.
/// @param energy must be valid where roughness > 0 counts.
BsdfData MakeBsdf(SurfaceModel model, const Rgb& color, float ior,
                  float roughness, const GgxEnergyView& energy);

RTB_HD inline float MaxComponent(const Rgb& c) {
  const float xy = c.x > c.y ? c.x : c.y;
  return xy > c.z ? xy : c.z;
}

/// The model has a GGX lobe of some width.
RTB_HD inline bool IsGlossy(const BsdfData& bsdf) {
  return (bsdf.model == SurfaceModel::kMetal ||
          bsdf.model == SurfaceModel::kPlastic) &&
         bsdf.alpha > 0;
}

/// Some light is reflected or refracted in one direction alone.
RTB_HD inline bool HasDelta(const BsdfData& bsdf) {
  switch (bsdf.model) {
    case SurfaceModel::kMirror:
    case SurfaceModel::kDielectric:
      return true;
    case SurfaceModel::kMetal:
    case SurfaceModel::kPlastic:
      return bsdf.alpha == 0;
    case SurfaceModel::kLambertian:
    case SurfaceModel::kPhong:
    case SurfaceModel::kEmissive:
      return false;
  }
  return false;
}

/// Some light is spread over directions: EvalBsdf is not 0 everywhere, and
/// lights are worth sampling.
RTB_HD inline bool HasNonDelta(const BsdfData& bsdf) {
  return bsdf.model == SurfaceModel::kLambertian ||
         bsdf.model == SurfaceModel::kPlastic || IsGlossy(bsdf);
}

}  // namespace rtb
