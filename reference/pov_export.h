/// @file
/// Export of a Scene to POV-Ray's scene description language.
#pragma once

#include <string>

#include "core/base/result.h"
#include "core/scene/scene.h"

namespace rtb {

/// The scene at `time` as an SDL file for POV-Ray 3.7, such that one center
/// ray per pixel gives the same linear radiance as the whitted integrator.
/// @return an Error naming the key when POV-Ray cannot express the same.
Result<std::string> ExportPov(const Scene& scene, double time);

}  // namespace rtb
