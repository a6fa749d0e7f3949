#include "core/shading/bsdf_data.h"

#include "core/base/check.h"
#include "core/shading/plastic.h"

namespace rtb {

BsdfData MakeBsdf(SurfaceModel model, const Rgb& color, float ior,
                  float roughness, const GgxEnergyView& energy) {
  RTB_CHECK(roughness >= 0 && roughness <= 1);
  BsdfData bsdf;
  bsdf.model = model;
  bsdf.color = color;
  bsdf.ior = ior;
  const float alpha = roughness * roughness;
  bsdf.alpha = alpha < kSmoothestAlpha ? 0 : alpha;
  if (model == SurfaceModel::kPlastic) {
    bsdf.average_fresnel = static_cast<float>(AverageFresnel(ior));
  }
  if (IsGlossy(bsdf)) {
    RTB_CHECK(energy.root_loss != nullptr);
    bsdf.average_loss = GgxAverageLoss(energy, bsdf.alpha);
  }
  return bsdf;
}

}  // namespace rtb
