/// @file
/// Meshes that objects name: each file is read once, and each way to render it
/// made once.
#include <system_error>

#include "core/scene/mesh_area.h"
#include "core/scene/scene_reader.h"
#include "core/scene/subdivide.h"

namespace rtb {
namespace {

constexpr const char* kUnusable = "`file` names a mesh that cannot be used: ";

/// The mesh of a file as an object wants it: subdivided, and with the normals
/// that it is shaded with, if any.
Result<TriangleMesh> Prepared(const ObjMesh& raw, const Mesh& mesh) {
  const std::string file = mesh.file.string();
  if (mesh.subdivide > 0) {
    return Subdivide(raw.mesh, mesh.subdivide, mesh.smooth, file);
  }
  RTB_RETURN_IF_ERROR(CheckSubdivision(raw.mesh.triangles.size(), 0, file));
  TriangleMesh result = raw.mesh;
  if (!mesh.smooth) result.normals.clear();
  return result;
}

}  // namespace

const ObjMesh* SceneReader::ReadObj(const std::filesystem::path& key,
                                    const Mesh& mesh, MapReader& reader) {
  const auto known = obj_files_.find(key);
  if (known != obj_files_.end()) return &known->second;
  Result<ObjMesh> obj = ReadObjMesh(mesh.file);
  if (!obj) {
    context_.Fail(reader.MarkOf("file"), kUnusable + obj.error().ToString());
    return nullptr;
  }
  for (std::string& warning : obj->warnings) {
    scene_.warnings.push_back(std::move(warning));
  }
  return &obj_files_.emplace(key, std::move(*obj)).first->second;
}

Index SceneReader::ReadMesh(const Mesh& mesh, MapReader& reader) {
  if (!context_.ok() || mesh.file.empty()) return kNone;
  std::error_code error;
  std::filesystem::path same = std::filesystem::canonical(mesh.file, error);
  if (error) same = mesh.file;
  const auto next = static_cast<Index>(scene_.meshes.size());
  const auto [place, added] =
      mesh_entries_.emplace(MeshKey{same, mesh.smooth, mesh.subdivide}, next);
  if (!added) return place->second;
  const ObjMesh* obj = ReadObj(same, mesh, reader);
  if (obj == nullptr) return kNone;
  Result<TriangleMesh> prepared = Prepared(*obj, mesh);
  if (!prepared) {
    context_.Fail(reader.MarkOf("subdivide"),
                  kUnusable + prepared.error().ToString());
    return kNone;
  }
  const int dropped = DropTrianglesWithoutArea(&*prepared);
  if (prepared->triangles.empty()) {
    context_.Fail(reader.MarkOf("subdivide"),
                  kUnusable + mesh.file.string() +
                      ": subdivided, no triangle has an area");
    return kNone;
  }
  if (dropped > 0) {
    scene_.warnings.push_back(
        mesh.file.string() + ": " + std::to_string(dropped) +
        " triangles without area were dropped after `subdivide: " +
        std::to_string(mesh.subdivide) + "`");
  }
  scene_.meshes.push_back(std::move(*prepared));
  return next;
}

}  // namespace rtb
