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

/// Reads all faces of an OBJ file as one mesh. Polygons are triangulated, also
/// where they are not convex; vertices are repeated where faces disagree on
/// normal or texture coordinate; triangles without an area (see HasArea) or
/// with a vertex that is not finite are dropped. Normals come out with length
/// 1; one of length 0 becomes that of a face at the vertex. A mesh has normals
/// and texture coordinates for all its corners or not at all. Whatever was
/// mended is among the warnings.
/// @return an Error that names the file (and line) when it is not acceptable
/// or has no triangle.
Result<ObjMesh> ReadObjMesh(const std::filesystem::path& file);

}  // namespace rtb
