#include "core/shading/shading_scene.h"

#include "core/base/check.h"
#include "core/scene/animation.h"
#include "core/shading/light_make.h"

namespace rtb {
namespace {

/// Turns a material's model into plain data.
struct MaterialConverter {
  MaterialData operator()(const Lambertian& m) const {
    return {SurfaceModel::kLambertian, m.albedo, 0, {}};
  }
  MaterialData operator()(const Mirror& m) const {
    return {SurfaceModel::kMirror, m.reflectance, 0, {}};
  }
  MaterialData operator()(const Metal& m) const {
    return {SurfaceModel::kMetal, m.albedo, 0, {}};
  }
  MaterialData operator()(const Dielectric& m) const {
    return {SurfaceModel::kDielectric, m.tint, static_cast<float>(m.ior), {}};
  }
  MaterialData operator()(const Emissive& m) const {
    return {SurfaceModel::kEmissive, m.radiance, 0, {}};
  }
  template <class Other>
  MaterialData operator()(const Other&) const {
    RTB_CHECK(!"a material that CheckRenderable refuses");
    return {};
  }
};

MaterialData Convert(const Material& material) {
  MaterialData data = std::visit(MaterialConverter{}, material.bsdf);
  if (const auto* checker = std::get_if<CheckerTexture>(&material.texture)) {
    data.checker = {checker->a, checker->b, static_cast<float>(checker->size)};
  }
  return data;
}

BackgroundData Convert(const Background& background) {
  if (const auto* c = std::get_if<ConstantBackground>(&background.kind)) {
    return {c->color, c->color};
  }
  const auto* gradient = std::get_if<GradientBackground>(&background.kind);
  RTB_CHECK(gradient != nullptr);
  return {gradient->bottom, gradient->top};
}

}  // namespace

ShadingScene MakeShadingScene(const Scene& scene, double time) {
  ShadingScene shading;
  for (const Material& m : scene.materials) {
    shading.materials.push_back(Convert(m));
  }
  shading.materials.push_back(MaterialData{});
  for (const Light& light : scene.lights) {
    V3d offset(0);
    if (light.path != kNone) {
      offset =
          PathOffset(scene.paths[static_cast<std::size_t>(light.path)], time);
    }
    shading.lights.push_back(ToLightData(light, offset));
  }
  shading.background = Convert(scene.background);
  shading.ambient = scene.settings.ambient;
  return shading;
}

ShadingView ViewOf(const ShadingScene& scene) {
  return {scene.materials.data(),
          scene.lights.data(),
          static_cast<int>(scene.materials.size()),
          static_cast<int>(scene.lights.size()),
          scene.background,
          scene.ambient};
}

Rgb ShadowTransmittance(const MaterialData& material) {
  return material.model == SurfaceModel::kDielectric ? material.color : Rgb(0);
}

}  // namespace rtb
