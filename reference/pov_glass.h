/// @file
/// Where POV-Ray's idea of a dielectric's inside is not the format's.
#pragma once

#include "core/base/result.h"
#include "core/scene/flat_scene.h"
#include "core/scene/scene.h"

namespace rtb {

/// POV-Ray keeps a list of the media that a ray is in, changed at every
/// surface; the format asks the outward normal, and beyond a surface is always
/// vacuum. Both agree on closed, outward surfaces that do not overlap: success
/// when every dielectric is one, else an Error. Overlap is judged by bounding
/// boxes (round spheres: exactly).
Status CheckPovGlass(const Scene& scene, const FlatScene& flat);

}  // namespace rtb
