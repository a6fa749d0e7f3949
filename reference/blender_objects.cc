#include "reference/blender_objects.h"

#include <algorithm>
#include <map>

#include "reference/blender_geometry.h"
#include "reference/blender_json.h"
#include "reference/bounds.h"

namespace rtb {
namespace {

using Json = nlohmann::ordered_json;

template <class Vec>
std::span<const float> FloatsOf(const std::vector<Vec>& vectors) {
  static_assert(sizeof(Vec) == Vec::dimensions() * sizeof(float));
  return {reinterpret_cast<const float*>(vectors.data()),
          vectors.size() * Vec::dimensions()};
}

Json ToJson(const BlenderMesh& mesh) {
  Json json = {
      {"positions", BlenderArray(FloatsOf(mesh.positions))},
      {"triangles", BlenderArray(std::span(
                        reinterpret_cast<const int*>(mesh.triangles.data()),
                        mesh.triangles.size() * 3))}};
  if (!mesh.uvs.empty()) json["uvs"] = BlenderArray(FloatsOf(mesh.uvs));
  if (!mesh.normals.empty()) {
    json["normals"] = BlenderArray(FloatsOf(mesh.normals));
  }
  return json;
}

/// Collects meshes and objects.
class ObjectWriter {
 public:
  ObjectWriter(const Scene& scene, const FlatScene& flat)
      : scene_(scene), flat_(flat) {}

  void Add(const FlatSphere& sphere) {
    const FlatObject& object = At(sphere.object);
    const Affined own = object.object_to_world.Inverse() * sphere.unit_to_world;
    objects_.push_back(
        {{"sphere", {own.origin.x, own.origin.y, own.origin.z, own.x.length()}},
         {"material", BlenderMaterialIndex(scene_, object)},
         {"matrix", BlenderMatrix(sphere.unit_to_world)}});
  }
  void Add(const BlenderMesh& mesh, Index object) {
    Place(static_cast<int>(meshes_.size()), object);
    meshes_.push_back(ToJson(mesh));
  }
  void Add(const FlatMesh& use) {
    const auto [place, added] =
        shared_.emplace(use.mesh, static_cast<int>(meshes_.size()));
    if (added) {
      meshes_.push_back(ToJson(
          BlenderMeshOf(scene_.meshes[static_cast<std::size_t>(use.mesh)])));
    }
    Place(place->second, use.object);
  }

  void LastIsInfinite() { objects_.back()["infinite"] = true; }

  Json Take() {
    return {{"meshes", std::move(meshes_)}, {"objects", std::move(objects_)}};
  }

 private:
  const FlatObject& At(Index object) const {
    return flat_.objects[static_cast<std::size_t>(object)];
  }
  void Place(int mesh, Index object) {
    objects_.push_back({{"mesh", mesh},
                        {"material", BlenderMaterialIndex(scene_, At(object))},
                        {"matrix", BlenderMatrix(At(object).object_to_world)}});
  }

  const Scene& scene_;
  const FlatScene& flat_;
  std::map<Index, int> shared_;
  Json meshes_ = Json::array();
  Json objects_ = Json::array();
};

/// The size of all that is finite, with the camera and its nearest points on
/// the planes.
double ReachOf(const Scene& scene, const FlatScene& flat, const V3d& camera) {
  Bounds bounds;
  bounds.Add(camera);
  for (const auto& sphere : flat.spheres) bounds.Add(BoundsOf(sphere));
  for (const auto& disk : flat.disks) bounds.Add(BoundsOf(disk));
  for (const auto& triangle : flat.triangles) bounds.Add(BoundsOf(triangle));
  for (const auto& use : flat.meshes) bounds.Add(BoundsOf(scene, flat, use));
  for (const FlatPlane& plane : flat.planes) {
    bounds.Add(camera - plane.normal * plane.normal.dot(camera - plane.point));
  }
  const double diagonal = bounds.Diagonal();
  return diagonal > 0 ? diagonal : 1;
}

}  // namespace

int BlenderMaterialIndex(const Scene& scene, const FlatObject& object) {
  const auto count = static_cast<int>(scene.materials.size());
  if (object.light != kNone) return count + 1 + object.light;
  return object.material == kNone ? count : object.material;
}

Json BlenderObjects(const Scene& scene, const FlatScene& flat,
                    const V3d& camera) {
  ObjectWriter writer(scene, flat);
  for (const FlatSphere& sphere : flat.spheres) writer.Add(sphere);
  for (const FlatDisk& disk : flat.disks) {
    writer.Add(BlenderDisk(flat, disk), disk.object);
  }
  const double reach = flat.planes.empty() ? 1 : ReachOf(scene, flat, camera);
  for (const FlatPlane& plane : flat.planes) {
    writer.Add(BlenderPlane(flat, plane, camera, reach), plane.object);
    writer.LastIsInfinite();
  }
  const auto& triangles = flat.triangles;
  for (std::size_t begin = 0, end = 0; begin < triangles.size(); begin = end) {
    const Index object = triangles[begin].object;
    while (end < triangles.size() && triangles[end].object == object) ++end;
    writer.Add(BlenderTriangles(flat, begin, end), object);
  }
  for (const FlatMesh& use : flat.meshes) writer.Add(use);
  return writer.Take();
}

}  // namespace rtb
