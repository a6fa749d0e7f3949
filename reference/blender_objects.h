/// @file
/// Everything that has a surface, in the JSON that Blender's Python reads.
#pragma once

#include <nlohmann/json.hpp>

#include "core/scene/flat_scene.h"
#include "core/scene/scene.h"

namespace rtb {

/// `{meshes: [..], objects: [{mesh | sphere, material, matrix}]}`: meshes in
/// coordinates of their own, which the objects place. A sphere is the unit
/// sphere under its matrix; `sphere` says where it lies in the coordinates
/// of its object: [center, radius]. `infinite`: true for planes.
/// @param flat with the shapes of the lights, whose material is that of the
///   light after those of the scene and the default one.
nlohmann::ordered_json BlenderObjects(const Scene& scene, const FlatScene& flat,
                                      const V3d& camera);

/// The power of two, at most 1, by which the exported world is larger than the
/// scene's. Cycles 3.4 samples a triangle that shines by its solid angle, found
/// with a cancellation that loses up to 1e-5 sr, where its distance is less
/// than its longest edge times twice its area: lengths are compared with
/// volumes. Far and grazing, a triangle of twice the area 4 then lights up to
/// 17 % too little; where that is 1/4 or less, no difference is measured.
double BlenderScale(const Scene& scene, const FlatScene& flat);

/// The same scene, larger.
void ScaleScene(double scale, FlatScene* flat);

/// The index of an object's material among the exported ones: the scene's,
/// the default, then one for each light.
int BlenderMaterialIndex(const Scene& scene, const FlatObject& object);

}  // namespace rtb
