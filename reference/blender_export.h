/// @file
/// Export of a Scene as a description from which Blender's Python builds it.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/scene/scene.h"
#include "reference/work_folder.h"

namespace rtb {

/// The scene at `time` as JSON, such that `reference/blender/render.py`, run
/// by Blender 3.4, builds it and Cycles renders the same radiance as the path
/// integrator (`path`), or as the whitted one (`whitted`: light from lamps
/// alone, no rough metal). Coordinates stay as they are, y up, but for a
/// power of two where Cycles' sampling of lights asks for it. Infinite planes
/// become squares, disks polygons; a mesh stands once in the file however
/// often it is used.
/// @return an Error naming the key when Cycles cannot express the same.
Result<std::string> ExportBlender(const Scene& scene, double time,
                                  const std::string& integrator = "path");

/// The Python files that read the JSON, `render.py` first.
std::vector<WorkFile> BlenderScripts();

}  // namespace rtb
