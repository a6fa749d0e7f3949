/// @file
/// From a scene's materials to plain data, on the host.
#pragma once

#include "core/base/result.h"
#include "core/scene/scene.h"
#include "core/shading/shading_scene.h"

namespace rtb {

/// The roughness of a metal or plastic; 0 for other materials.
double RoughnessOf(const Material& material);

/// Fills in materials, textures and bump maps, each image file read once.
/// @param shading its ggx_energy is there already where a material is rough.
/// @return an Error that names an image that cannot be used.
Status MakeMaterials(const Scene& scene, ShadingScene* shading);

}  // namespace rtb
