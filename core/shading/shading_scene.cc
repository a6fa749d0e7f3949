#include "core/shading/shading_scene.h"

#include "core/base/check.h"
#include "core/scene/animation.h"

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

/// Turns a light into plain data, moved by its path's offset.
struct LightConverter {
  V3d offset;

  LightData operator()(const PointLight& light) const {
    return {LightModel::kPoint, V3f(light.position + offset), V3f(0),
            light.intensity, light.inverse_square};
  }
  LightData operator()(const DirectionalLight& light) const {
    return {LightModel::kDirectional, V3f(0), V3f(light.direction.normalized()),
            light.irradiance, false};
  }
  template <class Other>
  LightData operator()(const Other&) const {
    RTB_CHECK(!"a light that CheckRenderable refuses");
    return {};
  }
};

BackgroundData Convert(const Background& background) {
  if (const auto* c = std::get_if<ConstantBackground>(&background.kind)) {
    return {c->color, c->color};
  }
  const auto* gradient = std::get_if<GradientBackground>(&background.kind);
  RTB_CHECK(gradient != nullptr);
  return {gradient->bottom, gradient->top};
}

}  // namespace

Result<ShadingScene> MakeShadingScene(const Scene& scene) {
  ShadingScene shading;
  for (const Material& m : scene.materials) {
    shading.materials.push_back(Convert(m));
  }
  shading.materials.push_back(MaterialData{});
  shading.background = Convert(scene.background);
  shading.ambient = scene.settings.ambient;
  return shading;
}

void PlaceLights(const Scene& scene, double time, const Geometry&,
                 ShadingScene* shading) {
  shading->lights.clear();
  for (const Light& light : scene.lights) {
    const V3d offset = LightOffset(scene, light, time);
    shading->lights.push_back(std::visit(LightConverter{offset}, light.kind));
  }
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
