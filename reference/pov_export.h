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
/// tolerances ask for it. Area lights are sums of `Declare=Emitters=N` fixed
/// emitters (by default 34; on spheres twice as many), not of `samples` random
/// ones. Rendered with `Declare=PassSide=N Declare=PassRow=J
/// Declare=PassColumn=I` the rays of the file go through the centers of the
/// cell (I, J) of the N x N into which each pixel is divided.
/// @return an Error naming the key when POV-Ray cannot express the same.
Result<std::string> ExportPov(const Scene& scene, double time);

}  // namespace rtb
