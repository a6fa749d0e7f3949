/// @file
/// Meshes that objects name: each file is read once.
#include <system_error>

#include "core/scene/obj_mesh.h"
#include "core/scene/scene_reader.h"

namespace rtb {

Index SceneReader::ReadMesh(const std::filesystem::path& file,
                            SourceMark mark) {
  if (!context_.ok() || file.empty()) return kNone;
  std::error_code error;
  std::filesystem::path same = std::filesystem::canonical(file, error);
  if (error) same = file;
  const auto next = static_cast<Index>(scene_.meshes.size());
  const auto [place, added] = mesh_files_.emplace(same, next);
  if (!added) return place->second;
  Result<ObjMesh> mesh = ReadObjMesh(file);
  if (!mesh) {
    context_.Fail(mark, "`file` names a mesh that cannot be used: " +
                            mesh.error().ToString());
    return kNone;
  }
  scene_.meshes.push_back(std::move(mesh->mesh));
  for (std::string& warning : mesh->warnings) {
    scene_.warnings.push_back(std::move(warning));
  }
  return next;
}

}  // namespace rtb
