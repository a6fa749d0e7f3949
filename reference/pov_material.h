/// @file
/// Materials in POV-Ray's scene description language.
#pragma once

#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/math/affine.h"
#include "core/scene/flat_scene.h"
#include "core/scene/scene.h"

namespace rtb {

/// Where a solid texture lies: p_pattern = (p_object - offset) / unit, in
/// cells, with p_object = object_to_world^-1 (p_world).
struct PatternPlacement {
  double unit = 1;
  V3d offset{0};
};

/// A checker of cells of `size` on a flat face: the format looks the pattern
/// up at the hit point moved by size/1000 along the unit object-space normal.
PatternPlacement CheckerOnFlat(double size, const V3d& object_normal);

/// The same on a sphere, in the object's own coordinates. There the normal is
/// (p - center) / radius, so that the move is a change of unit and offset.
PatternPlacement CheckerOnSphere(double size, const V3d& center, double radius);

/// The checker of a material, or nullptr.
const CheckerTexture* CheckerOf(const Material* material);

/// `texture { ... }`, and for a dielectric `interior { ... }` after it.
/// @param material nullptr = the format's default material; else one that
/// CheckPovMaterial accepts.
/// @param object_to_world scaled as the exported world is.
std::string PovMaterial(const Material* material, const Rgb& ambient,
                        const Affined& object_to_world,
                        const PatternPlacement& placement);

/// Success when POV-Ray can shade as the format says; else an Error that
/// names what it cannot express.
Status CheckPovMaterial(const Scene& scene, const Material& material);

/// `file:line:column` of something in the scene.
std::string PlaceOf(const Scene& scene, const SourceMark& mark);

}  // namespace rtb
