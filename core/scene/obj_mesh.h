/// @file
/// Triangle meshes from Wavefront OBJ files, through tinyobjloader.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/scene/scene.h"

namespace rtb {

/// A mesh and what had to be mended in it.
struct ObjMesh {
  TriangleMesh mesh;
  std::vector<std::string> warnings;  ///< One sentence each.
};

/// Reads all faces of an OBJ file as one mesh. Polygons are triangulated;
/// vertices are repeated where faces disagree on normal or texture coordinate;
/// triangles that are degenerate or have a vertex that is not finite are
/// dropped. Normals come out with length 1.
/// @return an Error that names the file (and line) when it is not acceptable
/// or has no triangle.
Result<ObjMesh> ReadObjMesh(const std::filesystem::path& file);

}  // namespace rtb
