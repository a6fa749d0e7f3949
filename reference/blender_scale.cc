#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/blender_geometry.h"
#include "reference/blender_objects.h"
#include "reference/bounds.h"
#include "reference/pov_text.h"

namespace rtb {
namespace {

/// Twice the area that no triangle which shines exceeds in the export.
constexpr double kLargestDoubleArea = 1.0 / 64;

/// The same of the unit sphere's triangles, of which there are 81,920.
constexpr double kSphereDoubleArea = 4e-4;

bool Shines(const Scene& scene, const FlatScene& flat, Index index) {
  const FlatObject& object = flat.objects[static_cast<std::size_t>(index)];
  if (object.light != kNone) return true;
  if (object.material == kNone) return false;
  const auto material = static_cast<std::size_t>(object.material);
  return std::holds_alternative<Emissive>(scene.materials[material].bsdf);
}

double DoubleArea(const FlatTriangle& triangle) {
  const V3d a(triangle.vertices[0]);
  return (V3d(triangle.vertices[1]) - a)
      .cross(V3d(triangle.vertices[2]) - a)
      .length();
}

/// Bounds for the largest of all triangles of a shape.
double DoubleArea(const FlatSphere& sphere) {
  const double extent = BoundsOf(sphere).Diagonal() / 2;
  return kSphereDoubleArea * extent * extent;
}
double DoubleArea(const FlatDisk& disk) {
  const double extent = BoundsOf(disk).Diagonal() / 2;
  return 2 * std::numbers::pi / kDiskSides * extent * extent;
}

}  // namespace

double BlenderScale(const Scene& scene, const FlatScene& flat) {
  double largest = 0;
  const auto grow = [&](const auto& shapes, const auto& double_area) {
    for (const auto& shape : shapes) {
      if (!Shines(scene, flat, shape.object)) continue;
      largest = std::max(largest, double_area(shape));
    }
  };
  const auto of_shape = [](const auto& shape) { return DoubleArea(shape); };
  grow(flat.triangles, of_shape);
  grow(flat.spheres, of_shape);
  grow(flat.disks, of_shape);
  grow(flat.meshes, [&](const FlatMesh& use) {
    const double extent = BoundsOf(scene, flat, use).Diagonal();
    return extent * extent;
  });
  if (largest <= kLargestDoubleArea) return 1;
  return std::exp2(std::floor(std::log2(kLargestDoubleArea / largest) / 2));
}

void ScaleScene(double scale, FlatScene* flat) {
  for (auto& object : flat->objects) {
    object.object_to_world = ScaledBy(object.object_to_world, scale);
  }
  for (auto& sphere : flat->spheres) {
    sphere.unit_to_world = ScaledBy(sphere.unit_to_world, scale);
  }
  for (auto& disk : flat->disks) {
    disk.unit_to_world = ScaledBy(disk.unit_to_world, scale);
  }
  for (auto& plane : flat->planes) plane.point *= scale;
  for (auto& triangle : flat->triangles) {
    for (V3f& vertex : triangle.vertices) vertex *= static_cast<float>(scale);
  }
}

}  // namespace rtb
