#include "core/shading/shading_scene.h"

#include "core/shading/material_make.h"

namespace rtb {
namespace {

const MaterialData& DefaultMaterial() {
  static const MaterialData material = [] {
    MaterialData data;
    data.bsdf.color = Rgb(0.5f);
    return data;
  }();
  return material;
}

Status SetBackground(const Background& background, ShadingScene* shading) {
  BackgroundData& data = shading->background;
  if (const auto* c = std::get_if<ConstantBackground>(&background.kind)) {
    data.bottom = data.top = c->color;
  }
  if (const auto* g = std::get_if<GradientBackground>(&background.kind)) {
    data.bottom = g->bottom;
    data.top = g->top;
  }
  if (const auto* image = std::get_if<ImageBackground>(&background.kind)) {
    RTB_ASSIGN_OR_RETURN(shading->environment, LoadEnvironment(image->file));
  }
  return {};
}

bool AnyTransparent(const std::vector<MaterialData>& materials) {
  for (const MaterialData& material : materials) {
    if (ShadowTransmittance(material) != Rgb(0)) return true;
  }
  return false;
}

bool AnyRough(const Scene& scene) {
  for (const Material& material : scene.materials) {
    if (RoughnessOf(material) > 0) return true;
  }
  return false;
}

}  // namespace

Result<ShadingScene> MakeShadingScene(const Scene& scene) {
  ShadingScene shading;
  if (AnyRough(scene)) shading.ggx_energy = MakeGgxEnergy();
  RTB_RETURN_IF_ERROR(MakeMaterials(scene, &shading));
  shading.materials.push_back(DefaultMaterial());
  shading.transparent = AnyTransparent(shading.materials);
  RTB_RETURN_IF_ERROR(SetBackground(scene.background, &shading));
  shading.ambient = scene.settings.ambient;
  return shading;
}

ShadingView ViewOf(const ShadingScene& scene) {
  const auto pointer = [](const auto& list) {
    return list.empty() ? nullptr : list.data();
  };
  ShadingView view;
  view.materials = scene.materials.data();
  view.lights = scene.lights.data();
  view.material_count = static_cast<int>(scene.materials.size());
  view.light_count = static_cast<int>(scene.lights.size());
  view.declared_lights = scene.declared_lights;
  view.background = scene.background;
  if (!scene.environment.image.empty()) {
    view.background.image = ViewOf(scene.environment);
  }
  view.ambient = scene.ambient;
  view.textures = scene.textures.data();
  view.bumps = scene.bumps.data();
  view.ggx_energy = ViewOf(scene.ggx_energy);
  view.light_cdf = scene.light_cdf.data();
  view.triangle_emitters = pointer(scene.emitters.triangles);
  view.sphere_emitters = pointer(scene.emitters.spheres);
  view.use_emitters = pointer(scene.emitters.uses);
  view.unsampled_emitters = scene.unsampled_emitters;
  view.transparent = scene.transparent;
  return view;
}

Rgb ShadowTransmittance(const MaterialData& material) {
  const bool glass = material.bsdf.model == SurfaceModel::kDielectric;
  return glass ? material.bsdf.color : Rgb(0);
}

}  // namespace rtb
