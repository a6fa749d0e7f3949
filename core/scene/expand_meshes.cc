#include <string>

#include "core/scene/flat_scene.h"
#include "core/scene/subdivide.h"

namespace rtb {
namespace {

/// One triangle of a mesh, placed in the world.
FlatTriangle Placed(const TriangleMesh& mesh, const std::array<int, 3>& indices,
                    const FlatObject& object, const Affined& to_object) {
  FlatTriangle triangle;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto i = static_cast<std::size_t>(indices[k]);
    triangle.vertices[k] =
        V3f(object.object_to_world.Point(V3d(mesh.positions[i])));
    if (!mesh.uvs.empty()) triangle.uvs[k] = mesh.uvs[i];
    if (!mesh.normals.empty()) {
      triangle.normals[k] =
          V3f(to_object.Transposed(V3d(mesh.normals[i])).normalized());
    }
  }
  return triangle;
}

void Expand(const Scene& scene, const FlatMesh& use, FlatScene* flat) {
  const auto& mesh = scene.meshes[static_cast<std::size_t>(use.mesh)];
  const FlatObject object = flat->objects[static_cast<std::size_t>(use.object)];
  const Affined to_object = object.object_to_world.Inverse();
  for (const auto& indices : mesh.triangles) {
    FlatTriangle triangle = Placed(mesh, indices, object, to_object);
    triangle.object = use.object;
    const auto& v = triangle.vertices;
    const V3d normal = V3d(v[1] - v[0]).cross(V3d(v[2] - v[0]));
    if (normal.length2() > 0) flat->triangles.push_back(triangle);
  }
}

}  // namespace

Status ExpandMeshes(const Scene& scene, FlatScene* flat) {
  std::size_t count = flat->triangles.size();
  for (const FlatMesh& use : flat->meshes) {
    count += scene.meshes[static_cast<std::size_t>(use.mesh)].triangles.size();
  }
  if (count > kMaxMeshTriangles) {
    return Fail(BadInput(scene.file.string(),
                         "the scene has " + std::to_string(count) +
                             " triangles once instances are expanded, and at "
                             "most " +
                             std::to_string(kMaxMeshTriangles) + " can be",
                         "use fewer instances or a coarser mesh"));
  }
  flat->triangles.reserve(count);
  for (const FlatMesh& use : flat->meshes) Expand(scene, use, flat);
  flat->meshes.clear();
  return {};
}

}  // namespace rtb
