/// @file
/// ShadingScene: the materials, lights and background of a Scene at one time
/// as plain arrays, the counterpart of accel's Geometry.
#pragma once

#include <vector>

#include "core/accel/geometry.h"
#include "core/base/host_device.h"
#include "core/base/result.h"
#include "core/scene/scene.h"
#include "core/shading/background.h"
#include "core/shading/light.h"
#include "core/shading/material.h"

namespace rtb {

/// Host-owned arrays.
struct ShadingScene {
  std::vector<MaterialData> materials;  ///< One more than the scene's: the
                                        ///< last is the default material.
  std::vector<LightData> lights;
  BackgroundData background;
  Rgb ambient{0};
};

/// The same as bare pointers, for host and device code.
struct ShadingView {
  const MaterialData* materials = nullptr;
  const LightData* lights = nullptr;
  int material_count = 0;
  int light_count = 0;
  BackgroundData background;
  Rgb ambient{0};

  /// The material of that index; kNone is the default, the last one.
  RTB_HD const MaterialData& material(int index) const {
    return materials[index < 0 ? material_count - 1 : index];
  }
};

/// Converts materials and background; lights come by PlaceLights.
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
