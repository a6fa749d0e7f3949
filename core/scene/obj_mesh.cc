#include "core/scene/obj_mesh.h"

#include <tiny_obj_loader.h>

#include <exception>
#include <optional>
#include <unordered_map>
#include <utility>

#include "core/base/file.h"
#include "core/scene/obj_text.h"

namespace rtb {
namespace {

constexpr std::size_t kMaxMeshBytes = std::size_t{1} << 30;

using Corner = tinyobj::index_t;

struct CornerHash {
  std::size_t operator()(const Corner& c) const {
    // Fibonacci hashing: Knuth, TAOCP volume 3, section 6.4.
    constexpr std::size_t kGolden = 0x9E3779B97F4A7C15u;
    const auto word = [](int i) { return static_cast<std::size_t>(i + 1); };
    return ((word(c.vertex_index) * kGolden + word(c.normal_index)) * kGolden +
            word(c.texcoord_index)) *
           kGolden;
  }
};
struct CornerEqual {
  bool operator()(const Corner& a, const Corner& b) const {
    return a.vertex_index == b.vertex_index &&
           a.normal_index == b.normal_index &&
           a.texcoord_index == b.texcoord_index;
  }
};

V3f VectorAt(const std::vector<tinyobj::real_t>& list, int index) {
  const std::size_t i = 3 * static_cast<std::size_t>(index);
  return {list[i], list[i + 1], list[i + 2]};
}

/// Merges the three indices of OBJ's corners into one.
class MeshBuilder {
 public:
  MeshBuilder(const tinyobj::attrib_t& attrib, const ObjText& text)
      : attrib_(attrib), non_finite_(text.non_finite) {}

  void AddShape(const tinyobj::mesh_t& shape) {
    for (std::size_t i = 0; i + 2 < shape.indices.size(); i += 3) {
      const std::array<Corner, 3> corners = {
          shape.indices[i], shape.indices[i + 1], shape.indices[i + 2]};
      AddTriangle(corners);
    }
  }

  /// The mesh; normals and texture coordinates only if all corners had them.
  TriangleMesh Take() {
    if (!all_normals_) mesh_.normals.clear();
    if (!all_uvs_) mesh_.uvs.clear();
    return std::move(mesh_);
  }
  int dropped() const { return dropped_; }

 private:
  void AddTriangle(const std::array<Corner, 3>& corners) {
    std::array<V3d, 3> v;
    for (std::size_t k = 0; k < 3; ++k) {
      v[k] = V3d(VectorAt(attrib_.vertices, corners[k].vertex_index));
      if (non_finite_.contains(corners[k].vertex_index)) return Drop();
    }
    if ((v[1] - v[0]).cross(v[2] - v[0]).length2() == 0) return Drop();
    std::array<int, 3> triangle{};
    for (std::size_t k = 0; k < 3; ++k) triangle[k] = VertexOf(corners[k]);
    mesh_.triangles.push_back(triangle);
  }

  void Drop() { ++dropped_; }

  int VertexOf(const Corner& corner) {
    const auto next = static_cast<int>(mesh_.positions.size());
    const auto [place, added] = vertices_.emplace(corner, next);
    if (added) {
      mesh_.positions.push_back(
          VectorAt(attrib_.vertices, corner.vertex_index));
      AddNormal(corner.normal_index);
      AddUv(corner.texcoord_index);
    }
    return place->second;
  }

  void AddNormal(int index) {
    const V3f normal =
        index < 0 ? V3f(0, 0, 0) : VectorAt(attrib_.normals, index);
    all_normals_ = all_normals_ && normal.length() > 0;
    mesh_.normals.push_back(normal.normalized());
  }

  void AddUv(int index) {
    all_uvs_ = all_uvs_ && index >= 0;
    const std::size_t i = 2 * static_cast<std::size_t>(std::max(index, 0));
    mesh_.uvs.push_back(
        index < 0 ? V2f(0, 0)
                  : V2f(attrib_.texcoords[i], attrib_.texcoords[i + 1]));
  }

  const tinyobj::attrib_t& attrib_;
  const std::set<int>& non_finite_;
  TriangleMesh mesh_;
  std::unordered_map<Corner, int, CornerHash, CornerEqual> vertices_;
  bool all_normals_ = true;
  bool all_uvs_ = true;
  int dropped_ = 0;
};

/// Runs tinyobjloader over a checked text.
std::optional<Error> Parse(const ObjText& text, const std::string& file,
                           tinyobj::ObjReader* reader) {
  tinyobj::ObjReaderConfig config;
  config.triangulate = true;
  config.vertex_color = false;
  try {
    if (reader->ParseFromString(text.text, "", config)) return {};
  } catch (const std::exception& e) {
    return BadInput(file, std::string("not readable as OBJ: ") + e.what());
  }
  return BadInput(file, "not readable as OBJ: " + reader->Error());
}

void Warn(int count, const std::string& words, const std::string& file,
          std::vector<std::string>* warnings) {
  if (count == 0) return;
  warnings->push_back(file + ": " + std::to_string(count) + " " + words);
}

}  // namespace

Result<ObjMesh> ReadObjMesh(const std::filesystem::path& path) {
  const std::string file = path.string();
  RTB_ASSIGN_OR_RETURN(const std::string bytes, ReadFile(path, kMaxMeshBytes));
  RTB_ASSIGN_OR_RETURN(const ObjText text, CheckObjText(bytes, file));
  tinyobj::ObjReader reader;
  if (auto error = Parse(text, file, &reader)) return Fail(*error);
  MeshBuilder builder(reader.GetAttrib(), text);
  for (const tinyobj::shape_t& shape : reader.GetShapes()) {
    builder.AddShape(shape.mesh);
  }
  ObjMesh result{builder.Take(), {}};
  if (result.mesh.triangles.empty()) {
    return Fail(BadInput(file,
                         "the mesh has no triangle, expected at least "
                         "one with an area"));
  }
  Warn(text.skipped_faces, "faces of fewer than three vertices were dropped",
       file, &result.warnings);
  Warn(builder.dropped(),
       "triangles without area, or with a vertex that is not finite, were "
       "dropped",
       file, &result.warnings);
  return result;
}

}  // namespace rtb
