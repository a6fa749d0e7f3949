/// @file
/// Primitives of a FlatScene in POV-Ray's scene description language.
#pragma once

#include <string>
#include <vector>

#include "core/scene/animation.h"
#include "core/scene/flat_scene.h"
#include "core/scene/scene.h"

namespace rtb {

/// The power of two by which the exported world is larger than the scene's.
/// POV-Ray's tolerances are absolute (1e-3 for shadows, nothing is seen past
/// 1e7), so a small scene is made 128 to 256 units large, a large one at most
/// 2048. The extent is that of the finite primitives, the camera, and the
/// camera's nearest points on the planes.
double PovScale(const FlatScene& flat, const V3d& camera);

/// Every primitive as an object with its material, lengths times `scale`.
/// Triangles of one object share a mesh; under a checker, those that also
/// share a normal.
std::string PovGeometry(const Scene& scene, const FlatScene& flat,
                        double scale);

/// The material of a primitive's object; nullptr = the default one.
const Material* MaterialOf(const Scene& scene, const FlatScene& flat,
                           Index object);

}  // namespace rtb
