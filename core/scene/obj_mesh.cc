#include "core/scene/obj_mesh.h"

#include <tiny_obj_loader.h>

#include <exception>
#include <optional>
#include <utility>

#include "core/base/file.h"
#include "core/scene/mesh_area.h"
#include "core/scene/obj_text.h"
#include "core/scene/triple_index.h"

namespace rtb {
namespace {

constexpr std::size_t kMaxMeshBytes = std::size_t{1} << 30;

using Corner = tinyobj::index_t;

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
    const auto triangle = [&](std::size_t i) {
      const tinyobj::index_t* corners = &shape.indices[3 * i];
      return Corners{corners[0], corners[1], corners[2]};
    };
    const std::size_t count = shape.indices.size() / 3;
    for (std::size_t i = 0; i < count; ++i) {
      if (shape.smoothing_group_ids[i] != kQuads || i + 1 == count) {
        AddTriangle(triangle(i));
        continue;
      }
      AddQuad(triangle(i), triangle(i + 1));
      ++i;
    }
  }

  /// The mesh; normals and texture coordinates only if all corners had them.
  TriangleMesh Take() {
    if (!all_normals_) mesh_.normals.clear();
    if (!all_uvs_) mesh_.uvs.clear();
    if (all_normals_) MendNormals();
    return std::move(mesh_);
  }
  int dropped() const { return dropped_; }
  /// Normals of length 0 (or not finite), which the faces around replaced.
  int mended_normals() const { return mended_normals_; }
  bool some_normals() const { return any_normal_ && !all_normals_; }
  bool some_uvs() const { return any_uv_ && !all_uvs_; }

 private:
  using Corners = std::array<Corner, 3>;

  V3f Position(const Corner& corner) const {
    return VectorAt(attrib_.vertices, corner.vertex_index);
  }
  V3d NormalOf(const Corners& c) const {
    const V3d origin(Position(c[0]));
    return (V3d(Position(c[1])) - origin).cross(V3d(Position(c[2])) - origin);
  }

  /// The two triangles that a quad was split into, along its shorter
  /// diagonal: where it is not convex that may lie outside, and one triangle
  /// turns its back; then the other diagonal is the right one.
  void AddQuad(const Corners& first, const Corners& second) {
    const bool from_first = Same(first[2], second[1]);  // (012, 023)
    const std::array<Corner, 4> q = {first[0], first[1],
                                     from_first ? first[2] : second[1],
                                     from_first ? second[2] : first[2]};
    const Corners other_first = {q[0], q[1], from_first ? q[3] : q[2]};
    const Corners other_second = {from_first ? q[1] : q[0], q[2], q[3]};
    const bool folded = NormalOf(first).dot(NormalOf(second)) < 0;
    const bool mends =
        folded && NormalOf(other_first).dot(NormalOf(other_second)) > 0;
    AddTriangle(mends ? other_first : first);
    AddTriangle(mends ? other_second : second);
  }

  static bool Same(const Corner& a, const Corner& b) {
    return a.vertex_index == b.vertex_index &&
           a.normal_index == b.normal_index &&
           a.texcoord_index == b.texcoord_index;
  }

  void AddTriangle(const Corners& corners) {
    for (const Corner& corner : corners) {
      if (non_finite_.contains(corner.vertex_index)) return Drop();
    }
    if (!HasArea(Position(corners[0]), Position(corners[1]),
                 Position(corners[2]))) {
      return Drop();
    }
    std::array<int, 3> triangle{};
    for (std::size_t k = 0; k < 3; ++k) triangle[k] = VertexOf(corners[k]);
    mesh_.triangles.push_back(triangle);
  }

  void Drop() { ++dropped_; }

  int VertexOf(const Corner& corner) {
    const auto word = [](int i) { return static_cast<std::uint32_t>(i); };
    const auto [vertex, added] =
        vertices_.Number({word(corner.vertex_index), word(corner.normal_index),
                          word(corner.texcoord_index)});
    if (added) {
      mesh_.positions.push_back(Position(corner));
      AddNormal(corner.normal_index);
      AddUv(corner.texcoord_index);
    }
    return vertex;
  }

  void AddNormal(int index) {
    all_normals_ = all_normals_ && index >= 0;
    any_normal_ = any_normal_ || index >= 0;
    const V3f normal =
        index < 0 ? V3f(0, 0, 0) : VectorAt(attrib_.normals, index);
    // In double precision, where no square overflows.
    mesh_.normals.push_back(V3f(V3d(normal).normalized()));
  }

  void AddUv(int index) {
    all_uvs_ = all_uvs_ && index >= 0;
    any_uv_ = any_uv_ || index >= 0;
    const std::size_t i = 2 * static_cast<std::size_t>(std::max(index, 0));
    mesh_.uvs.push_back(
        index < 0 ? V2f(0, 0)
                  : V2f(attrib_.texcoords[i], attrib_.texcoords[i + 1]));
  }

  /// Gives vertices with a normal of length 0 that of a triangle there.
  void MendNormals() {
    for (const auto& [a, b, c] : mesh_.triangles) {
      const auto at = [this](int i) {
        return V3d(mesh_.positions[static_cast<std::size_t>(i)]);
      };
      for (const int i : {a, b, c}) {
        V3f& normal = mesh_.normals[static_cast<std::size_t>(i)];
        if (normal != V3f(0, 0, 0)) continue;
        normal = V3f((at(b) - at(a)).cross(at(c) - at(a)).normalized());
        ++mended_normals_;
      }
    }
  }

  const tinyobj::attrib_t& attrib_;
  const std::set<int>& non_finite_;
  TriangleMesh mesh_;
  TripleIndex vertices_;
  bool all_normals_ = true;
  bool all_uvs_ = true;
  bool any_normal_ = false;
  bool any_uv_ = false;
  int dropped_ = 0;
  int mended_normals_ = 0;
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
  const auto warn = [&](int count, const char* words) {
    if (count == 0) return;
    result.warnings.push_back(file + ": " + std::to_string(count) + words);
  };
  warn(text.skipped_faces, " faces of fewer than three vertices were dropped");
  warn(builder.dropped(),
       " triangles without area, or with a vertex that is not finite, were "
       "dropped");
  warn(builder.mended_normals(),
       " normals of length 0, or not finite, were replaced by a face's");
  warn(text.non_finite_uvs,
       " texture coordinates that are not finite became 0");
  if (builder.some_normals()) {
    result.warnings.push_back(
        file + ": normals were left out, as some corners have none");
  }
  if (builder.some_uvs()) {
    result.warnings.push_back(
        file +
        ": texture coordinates were left out, as some corners have "
        "none");
  }
  return result;
}

}  // namespace rtb
