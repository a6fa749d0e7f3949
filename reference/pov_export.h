/// @file
/// Export of a Scene to POV-Ray's scene description language.
#pragma once

#include <string>

#include "core/base/result.h"
#include "core/scene/scene.h"

namespace rtb {

/// The scene at `time` as an SDL file for POV-Ray 3.7, such that one center
/// ray per pixel gives the same linear radiance as the whitted integrator.
/// Lengths are multiplied by a power of two where POV-Ray's absolute
/// tolerances ask for it. Area lights are sums of at least 89 (quad) or 178
/// (sphere) fixed emitters, not of `samples` random ones. Rendered with
/// `Declare=BandRows=R Declare=BandBegin=A Declare=BandEnd=B` the file gives
/// rows A to B - 1 of a picture of R rows alone.
/// @return an Error naming the key when POV-Ray cannot express the same.
Result<std::string> ExportPov(const Scene& scene, double time);

}  // namespace rtb
