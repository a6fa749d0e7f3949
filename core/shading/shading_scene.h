/// @file
/// ShadingScene: the materials, textures, lights and background of a Scene as
/// plain arrays, the counterpart of accel's Geometry.
#pragma once

#include <vector>

#include "core/accel/geometry.h"
#include "core/base/host_device.h"
#include "core/base/result.h"
#include "core/scene/scene.h"
#include "core/shading/background.h"
#include "core/shading/bump.h"
#include "core/shading/environment_load.h"
#include "core/shading/ggx_energy.h"
#include "core/shading/light_data.h"
#include "core/shading/material.h"
#include "core/shading/mip_chain.h"
#include "core/shading/texture.h"
#include "core/shading/texture_load.h"

namespace rtb {

/// Which entry of the lights a primitive of an emissive object is, so that
/// the path integrator can weigh a hit of it; -1 = none. An empty list says
/// that no primitive of the kind is an emitter.
struct EmitterIndices {
  std::vector<int> triangles;
  std::vector<int> spheres;
  std::vector<int> uses;  ///< The light of a placed mesh's first triangle.
};

/// Host-owned arrays.
struct ShadingScene {
  std::vector<MaterialData> materials;  ///< One more than the scene's: the
                                        ///< last is the default material.
  std::vector<MipChain<Rgb>> texture_images;
  std::vector<ImageTextureData> textures;
  std::vector<MipChain<float>> height_maps;
  std::vector<BumpData> bumps;
  Environment environment;
  BackgroundData background;
  GgxEnergy ggx_energy;
  Rgb ambient{0};

  /// The scene's lights in its order, then triangles and spheres of emissive
  /// objects.
  std::vector<LightData> lights;
  EmitterIndices emitters;
  /// Some emissive object can only be found by chance.
  bool unsampled_emitters = false;
  /// Some material lets shadow rays pass.
  bool transparent = false;
  /// For choosing among the lights and, last, the background.
  std::vector<float> light_cdf;
  int declared_lights = 0;
};

/// The same as bare pointers, for host and device code.
struct ShadingView {
  const MaterialData* materials = nullptr;
  const LightData* lights = nullptr;
  int material_count = 0;
  int light_count = 0;
  int declared_lights = 0;  ///< The scene's own, which come first.
  BackgroundData background;
  Rgb ambient{0};
  const ImageTextureData* textures = nullptr;
  const BumpData* bumps = nullptr;
  GgxEnergyView ggx_energy;
  const float* light_cdf = nullptr;  ///< light_count + 2 numbers.
  const int* triangle_emitters = nullptr;
  const int* sphere_emitters = nullptr;
  const int* use_emitters = nullptr;
  bool unsampled_emitters = false;
  bool transparent = false;

  /// The material of that index; kNone is the default, the last one.
  RTB_HD const MaterialData& material(int index) const {
    return materials[index < 0 ? material_count - 1 : index];
  }
};

/// Converts materials and background and reads their images; lights come by
/// PlaceLights. @return an Error that names an image that cannot be used.
Result<ShadingScene> MakeShadingScene(const Scene& scene);

/// Puts the lights where they are at `time`.
/// @param geometry the scene's at that time.
void PlaceLights(const Scene& scene, double time, const Geometry& geometry,
                 ShadingScene* shading);

/// A view of a ShadingScene, which must outlive it.
ShadingView ViewOf(const ShadingScene& scene);

/// The share of light that passes straight through a surface of the material
/// at one crossing, as shadow rays see it: a dielectric's tint, else 0.
Rgb ShadowTransmittance(const MaterialData& material);

}  // namespace rtb
