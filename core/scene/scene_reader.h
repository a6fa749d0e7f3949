/// @file
/// SceneReader: what the parts of the scene loader share. Each part reads one
/// section of the file; errors gather in the ReadContext.
#pragma once

#include <compare>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "core/scene/obj_mesh.h"
#include "core/scene/scene.h"
#include "core/scene/yaml_reader.h"

namespace rtb {

/// Objects after composition, and levels of nesting.
inline constexpr int kMaxObjects = 1'000'000;
inline constexpr int kMaxObjectDepth = 64;

/// Ids of a list of the scene, with their positions in it.
using IdMap = std::map<std::string, Index, std::less<>>;

/// What makes an entry of Scene::meshes.
struct MeshKey {
  std::filesystem::path file;
  bool smooth = true;
  int subdivide = 0;
  auto operator<=>(const MeshKey&) const = default;
};

/// A scene under construction.
class SceneReader {
 public:
  SceneReader(const std::filesystem::path& file, ReadContext& context)
      : context_(context) {
    scene_.file = file;
  }

  /// Reads all sections; the context says whether that went well.
  void Read(YamlNode root);
  Scene& scene() { return scene_; }

 private:
  // One file each: load_paths.cc, load_materials.cc, ...
  void ReadPaths(MapReader& root);
  void ReadPath(YamlNode node);
  void ReadMaterials(MapReader& root);
  void ReadMaterial(YamlNode node);
  Texture ReadTexture(MapReader& material);
  void ReadBump(MapReader& material, Material* result);
  void ReadCamera(MapReader& root);
  void ReadView(MapReader& camera, Camera* result);
  /// A path's offset at time 0; zero without a path.
  V3d FirstOffset(Index path) const;
  void ReadBackground(MapReader& root);
  void ReadSettings(MapReader& root);
  void ReadLights(MapReader& root);
  void ReadLight(YamlNode node);
  void ReadObjects(MapReader& root);
  Object ReadObject(YamlNode node, int level);
  void ReadTransform(MapReader& object, Object* result);
  void ReadCompound(MapReader& reader, int kind, int level, Object* object);
  /// The entry of Scene::meshes that a mesh is rendered from. Equal file,
  /// `smooth` and `subdivide` share one; each file is parsed once.
  Index ReadMesh(const Mesh& mesh, MapReader& reader);
  /// The parsed file of a mesh, by its canonical name; null after an error.
  const ObjMesh* ReadObj(const std::filesystem::path& key, const Mesh& mesh,
                         MapReader& reader);

  /// The items of an optional list-valued key.
  std::vector<YamlNode> Section(MapReader& root, std::string_view key);
  /// Resolves the optional key `key` that names an entry of `ids`.
  Index Reference(MapReader& reader, std::string_view key, const IdMap& ids);
  /// Notes an id, which must be new.
  void AddId(MapReader& reader, const std::string& id, Index index, IdMap* ids);
  /// A required key that names a regular file, relative to the scene's.
  std::filesystem::path File(MapReader& reader);

  ReadContext& context_;
  Scene scene_;
  IdMap path_ids_, material_ids_, light_ids_, object_ids_;
  std::map<std::filesystem::path, ObjMesh> obj_files_;
  std::map<MeshKey, Index> mesh_entries_;
  std::set<std::filesystem::path> known_files_;
  int objects_ = 0;
};

/// Checks what concerns the tree as a whole: instances name groups or meshes
/// and never themselves; composition stays within the limits.
/// The scene's objects have been indexed.
/// @return the first error.
Status CheckComposition(const Scene& scene);

}  // namespace rtb
