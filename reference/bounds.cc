#include "reference/bounds.h"

#include <algorithm>
#include <cmath>

namespace rtb {
namespace {

/// Box around center +- half.
Bounds Around(const V3d& center, const V3d& half) {
  Bounds bounds;
  bounds.min = center - half;
  bounds.max = center + half;
  return bounds;
}

}  // namespace

void Bounds::Add(const V3d& point) {
  for (int i = 0; i < 3; ++i) {
    min[i] = std::min(min[i], point[i]);
    max[i] = std::max(max[i], point[i]);
  }
}

void Bounds::Add(const Bounds& other) {
  for (int i = 0; i < 3; ++i) {
    min[i] = std::min(min[i], other.min[i]);
    max[i] = std::max(max[i], other.max[i]);
  }
}

double Bounds::Diagonal() const {
  return min.x > max.x ? 0 : (max - min).length();
}

Bounds BoundsOf(const FlatSphere& sphere) {
  // The image of the unit sphere reaches |row of the linear part| each way.
  const Affined& m = sphere.unit_to_world;
  V3d half(0);
  for (int i = 0; i < 3; ++i) {
    half[i] = V3d(m.x[i], m.y[i], m.z[i]).length();
  }
  return Around(m.origin, half);
}

Bounds BoundsOf(const FlatDisk& disk) {
  const Affined& m = disk.unit_to_world;
  V3d half(0);
  for (int i = 0; i < 3; ++i) half[i] = std::hypot(m.x[i], m.y[i]);
  return Around(m.origin, half);
}

Bounds BoundsOf(const FlatTriangle& triangle) {
  Bounds bounds;
  for (const V3f& vertex : triangle.vertices) bounds.Add(V3d(vertex));
  return bounds;
}

Bounds BoundsOf(const Scene& scene, const FlatScene& flat,
                const FlatMesh& use) {
  const auto& map =
      flat.objects[static_cast<std::size_t>(use.object)].object_to_world;
  Bounds bounds;
  for (const V3f& p :
       scene.meshes[static_cast<std::size_t>(use.mesh)].positions) {
    bounds.Add(map.Point(V3d(p)));
  }
  return bounds;
}

bool Overlap(const Bounds& a, const Bounds& b) {
  for (int i = 0; i < 3; ++i) {
    if (a.min[i] >= b.max[i] || b.min[i] >= a.max[i]) return false;
  }
  return true;
}

}  // namespace rtb
