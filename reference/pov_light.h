/// @file
/// Lights in POV-Ray's scene description language.
#pragma once

#include <string>

#include "core/scene/scene.h"

namespace rtb {

/// Every light of a scene at `time`, their coordinates multiplied by `scale`.
/// Area lights become cosine emitters and a seen surface.
std::string PovLights(const Scene& scene, double time, double scale);

}  // namespace rtb
