/// @file
/// Lights with an area in POV-Ray's scene description language.
#pragma once

#include <string>

#include "core/math/vec.h"
#include "core/scene/scene.h"

namespace rtb {

/// The macros that PovQuadLight and PovSphereLight call, once per file. They
/// take `Emitters` (and the pass) from the command line and have defaults.
std::string PovEmitterMacros();

/// @name A light that shines and is seen
/// Its area shines as a sum of small flat emitters, of which each pass of a
/// picture has others: `Emitters` on a quad, twice as many on a sphere, of
/// which half face any one point.
/// @param offset where the light's path has moved it, in the scene's units.
/// @param scale by which the exported world is larger than the scene's.
/// @{
std::string PovQuadLight(const QuadLight& light, const V3d& offset,
                         double scale);
std::string PovSphereLight(const SphereLight& light, const V3d& offset,
                           double scale);
/// @}

}  // namespace rtb
