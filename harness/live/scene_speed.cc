#include "harness/live/scene_speed.h"

#include <Imath/ImathBox.h>

#include <cmath>
#include <vector>

#include "core/scene/flat_scene.h"

namespace rtb {
namespace {

using Box3d = Imath::Box3d;

/// The box of a box's corners under a map.
void ExtendBy(const Affined& map, const Box3d& box, Box3d* all) {
  if (box.isEmpty()) return;
  for (int corner = 0; corner < 8; ++corner) {
    all->extendBy(map.Point(V3d((corner & 1) ? box.max.x : box.min.x,
                                (corner & 2) ? box.max.y : box.min.y,
                                (corner & 4) ? box.max.z : box.min.z)));
  }
}

Box3d BoxOf(const TriangleMesh& mesh) {
  Box3d box;
  for (const V3f& position : mesh.positions) box.extendBy(V3d(position));
  return box;
}

Box3d BoxOf(const FlatScene& flat, const std::vector<TriangleMesh>& meshes) {
  const Box3d ball(V3d(-1, -1, -1), V3d(1, 1, 1));
  std::vector<Box3d> mesh_boxes;
  for (const TriangleMesh& mesh : meshes) mesh_boxes.push_back(BoxOf(mesh));
  Box3d all;
  for (const FlatSphere& sphere : flat.spheres) {
    ExtendBy(sphere.unit_to_world, ball, &all);
  }
  for (const FlatDisk& disk : flat.disks) {
    ExtendBy(disk.unit_to_world, Box3d(V3d(-1, -1, 0), V3d(1, 1, 0)), &all);
  }
  for (const FlatTriangle& triangle : flat.triangles) {
    for (const V3f& vertex : triangle.vertices) all.extendBy(V3d(vertex));
  }
  for (const FlatMesh& mesh : flat.meshes) {
    ExtendBy(
        flat.objects[static_cast<std::size_t>(mesh.object)].object_to_world,
        mesh_boxes[static_cast<std::size_t>(mesh.mesh)], &all);
  }
  return all;
}

}  // namespace

double SceneSpeed(const Scene& scene) {
  if (scene.camera.speed) return *scene.camera.speed;
  const auto flat = Flatten(scene, 0);
  if (!flat) return 1;
  const Box3d box = BoxOf(*flat, scene.meshes);
  const double diagonal = box.isEmpty() ? 0 : box.size().length();
  return std::isfinite(diagonal) && diagonal > 0 ? diagonal / 10 : 1;
}

}  // namespace rtb
