/// @file
/// From a Hit to the surface: the point is recomputed from the primitive, so
/// that its error does not grow with the length of the ray.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/accel/geometry.h"
#include "core/accel/ray.h"
#include "core/base/host_device.h"

namespace rtb {

/// Largest absolute component.
RTB_HD inline float MaxAbs(const V3f& v) {
  return std::max(std::max(std::abs(v.x), std::abs(v.y)), std::abs(v.z));
}

/// The unit vector of a cross product of edges of any size.
RTB_HD inline V3f UnitCross(const V3f& e0, const V3f& e1) {
  const V3f n = (e0 / MaxAbs(e0)).cross(e1 / MaxAbs(e1));
  return (n / MaxAbs(n)).normalized();
}

RTB_HD inline SurfacePoint TriangleSurface(const GeometryView& g,
                                           const Hit& hit) {
  const V3f* v = g.vertices + 3 * static_cast<std::size_t>(hit.primitive);
  SurfacePoint point;
  const V3f e0 = v[1] - v[0];
  const V3f e1 = v[2] - v[0];
  point.position = v[0] + (e0 * hit.u + e1 * hit.v);
  point.normal = UnitCross(e0, e1);
  point.scale = std::max(std::max(MaxAbs(v[0]), MaxAbs(v[1])), MaxAbs(v[2]));
  point.object = g.triangle_objects[hit.primitive];
  point.shading_normal = point.normal;
  return point;
}

/// Componentwise absolute values.
RTB_HD inline V3f Abs(const V3f& v) {
  return V3f(std::abs(v.x), std::abs(v.y), std::abs(v.z));
}

/// A unit normal of mesh space, in the world.
RTB_HD inline V3f NormalToWorld(const Affinef& world_to_object, const V3f& n) {
  const V3f world = world_to_object.Transposed(n);
  return (world / MaxAbs(world)).normalized();
}

RTB_HD inline SurfacePoint MeshSurface(const GeometryView& g, const Hit& hit) {
  const MeshUse& use = g.uses[hit.use];
  const MeshData& mesh = g.meshes[use.mesh];
  const auto& [a, b, c] = mesh.triangles[hit.primitive];
  const V3f& v0 = mesh.positions[a];
  const V3f e0 = mesh.positions[b] - v0;
  const V3f e1 = mesh.positions[c] - v0;
  const Affinef& world_to_object = g.objects[use.object].world_to_object;
  SurfacePoint point;
  point.position = use.to_world.Point(v0 + (e0 * hit.u + e1 * hit.v));
  point.normal = NormalToWorld(world_to_object, UnitCross(e0, e1));
  // What enters a placed position, and a ray's way into mesh space.
  const V3f reach = Abs(v0) + Abs(e0) + Abs(e1);
  const Affinef& m = use.to_world;
  point.scale = MaxAbs(Abs(m.x) * reach.x + Abs(m.y) * reach.y +
                       Abs(m.z) * reach.z + Abs(m.origin));
  point.object = use.object;
  point.shading_normal = point.normal;
  if (mesh.normals != nullptr) {
    const V3f n = mesh.normals[a] * (1 - hit.u - hit.v) +
                  mesh.normals[b] * hit.u + mesh.normals[c] * hit.v;
    if (MaxAbs(n) > 0) {
      point.shading_normal = NormalToWorld(world_to_object, n.normalized());
    }
  }
  return point;
}

RTB_HD inline SurfacePoint SphereSurface(const Quadric& sphere,
                                         const V3f& approximate) {
  // Projected onto the unit sphere, then mapped back.
  const V3f unit =
      sphere.to_unit.Direction(approximate - sphere.center).normalized();
  const V3f normal = NormalToWorld(sphere.to_unit, unit);
  return {sphere.center + sphere.to_world.Direction(unit), normal, sphere.scale,
          sphere.object, normal};
}

RTB_HD inline SurfacePoint DiskSurface(const Quadric& disk,
                                       const V3f& approximate) {
  V3f unit = disk.to_unit.Direction(approximate - disk.center);
  unit.z = 0;
  const V3f normal = NormalToWorld(disk.to_unit, V3f(0, 0, 1));
  return {disk.center + disk.to_world.Direction(unit), normal, disk.scale,
          disk.object, normal};
}

RTB_HD inline SurfacePoint PlaneSurface(const PlaneData& plane,
                                        const V3f& approximate) {
  const float above = plane.normal.dot(approximate - plane.point);
  const V3f position = approximate - plane.normal * above;
  return {position, plane.normal,
          std::max(MaxAbs(position), MaxAbs(plane.point)), plane.object,
          plane.normal};
}

/// The surface at a hit; `hit.kind` is not kNothing.
RTB_HD inline SurfacePoint SurfaceAt(const GeometryView& geometry,
                                     const Ray& ray, const Hit& hit) {
  if (hit.kind == PrimitiveKind::kTriangle) {
    return TriangleSurface(geometry, hit);
  }
  if (hit.kind == PrimitiveKind::kMesh) return MeshSurface(geometry, hit);
  const V3f approximate = ray.origin + ray.direction * hit.t;
  switch (hit.kind) {
    case PrimitiveKind::kSphere:
      return SphereSurface(geometry.spheres[hit.primitive], approximate);
    case PrimitiveKind::kDisk:
      return DiskSurface(geometry.disks[hit.primitive], approximate);
    default:
      return PlaneSurface(geometry.planes[hit.primitive], approximate);
  }
}

}  // namespace rtb
