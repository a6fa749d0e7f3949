#include "core/accel/geometry.h"

#include <algorithm>
#include <cmath>

namespace rtb {
namespace {

float LargestComponent(const V3d& v) {
  return static_cast<float>(
      std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}));
}

/// The linear part alone.
Affined Linear(Affined map) {
  map.origin = V3d(0);
  return map;
}

/// @param third whether the unit shape extends along its third axis.
Quadric MakeQuadric(const Affined& unit_to_world, int object, bool third) {
  const Affined& m = unit_to_world;
  // Half extent of an affine image of the unit sphere: the row norms.
  V3d half(0);
  for (int axis = 0; axis < 3; ++axis) {
    const double z = third ? m.z[axis] : 0;
    half[axis] =
        std::sqrt(m.x[axis] * m.x[axis] + m.y[axis] * m.y[axis] + z * z);
  }
  Quadric quadric;
  quadric.center = V3f(m.origin);
  quadric.to_world = ToFloat(Linear(m));
  quadric.to_unit = ToFloat(Linear(Linear(m).Inverse()));
  quadric.half_extent = V3f(half);
  const V3d reach(std::abs(m.origin.x) + half.x, std::abs(m.origin.y) + half.y,
                  std::abs(m.origin.z) + half.z);
  quadric.scale = LargestComponent(reach);
  quadric.object = object;
  return quadric;
}

}  // namespace

Geometry MakeGeometry(const FlatScene& flat) {
  Geometry geometry;
  for (const FlatTriangle& triangle : flat.triangles) {
    for (const V3f& v : triangle.vertices) geometry.vertices.push_back(v);
    geometry.triangle_objects.push_back(triangle.object);
  }
  for (const FlatSphere& s : flat.spheres) {
    geometry.spheres.push_back(MakeQuadric(s.unit_to_world, s.object, true));
  }
  for (const FlatDisk& d : flat.disks) {
    geometry.disks.push_back(MakeQuadric(d.unit_to_world, d.object, false));
  }
  for (const FlatPlane& p : flat.planes) {
    geometry.planes.push_back({V3f(p.point), V3f(p.normal), p.object});
  }
  for (const FlatObject& object : flat.objects) {
    geometry.objects.push_back(
        {object.material, ToFloat(object.object_to_world.Inverse())});
  }
  return geometry;
}

GeometryView ViewOf(const Geometry& geometry) {
  return {geometry.vertices.data(),
          geometry.triangle_objects.data(),
          geometry.spheres.data(),
          geometry.disks.data(),
          geometry.planes.data(),
          geometry.objects.data(),
          static_cast<int>(geometry.planes.size())};
}

}  // namespace rtb
