/// @file
/// Everything that has a surface, in the JSON that Blender's Python reads.
#pragma once

#include <nlohmann/json.hpp>

#include "core/scene/flat_scene.h"
#include "core/scene/scene.h"

namespace rtb {

/// `{meshes: [..], objects: [{mesh | sphere, material, matrix}]}`: meshes in
/// coordinates of their own, which the objects place. A sphere is the unit
/// sphere under its matrix; `own` then says where it lies in the coordinates
/// of its object: [center, radius].
/// @param flat with the shapes of the lights, whose material is that of the
///   light after those of the scene and the default one.
nlohmann::ordered_json BlenderObjects(const Scene& scene, const FlatScene& flat,
                                      const V3d& camera);

/// The index of an object's material among the exported ones: the scene's,
/// the default, then one for each light.
int BlenderMaterialIndex(const Scene& scene, const FlatObject& object);

}  // namespace rtb
