/// @file
/// Lights in POV-Ray's scene description language.
#pragma once

#include <string>

#include "core/base/result.h"
#include "core/scene/scene.h"

namespace rtb {

/// A light at `time`, its coordinates multiplied by `scale`. Area lights
/// become a lattice of at least 89 cosine emitters and a seen surface.
/// @param light one that CheckPovLight accepts.
std::string PovLight(const Scene& scene, const Light& light, double time,
                     double scale);

/// Success when POV-Ray can light as the format says.
Status CheckPovLight(const Scene& scene, const Light& light);

}  // namespace rtb
