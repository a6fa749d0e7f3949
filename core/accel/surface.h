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
  return point;
}

RTB_HD inline SurfacePoint SphereSurface(const Quadric& sphere,
                                         const V3f& approximate) {
  // Projected onto the unit sphere, then mapped back.
  const V3f unit =
      sphere.to_unit.Direction(approximate - sphere.center).normalized();
  const V3f normal = sphere.to_unit.Transposed(unit);
  return {sphere.center + sphere.to_world.Direction(unit),
          (normal / MaxAbs(normal)).normalized(), sphere.scale, sphere.object};
}

RTB_HD inline SurfacePoint DiskSurface(const Quadric& disk,
                                       const V3f& approximate) {
  V3f unit = disk.to_unit.Direction(approximate - disk.center);
  unit.z = 0;
  const V3f normal = disk.to_unit.Transposed(V3f(0, 0, 1));
  return {disk.center + disk.to_world.Direction(unit),
          (normal / MaxAbs(normal)).normalized(), disk.scale, disk.object};
}

RTB_HD inline SurfacePoint PlaneSurface(const PlaneData& plane,
                                        const V3f& approximate) {
  const float above = plane.normal.dot(approximate - plane.point);
  const V3f position = approximate - plane.normal * above;
  return {position, plane.normal,
          std::max(MaxAbs(position), MaxAbs(plane.point)), plane.object};
}

/// The surface at a hit; `hit.kind` is not kNothing.
RTB_HD inline SurfacePoint SurfaceAt(const GeometryView& geometry,
                                     const Ray& ray, const Hit& hit) {
  if (hit.kind == PrimitiveKind::kTriangle) {
    return TriangleSurface(geometry, hit);
  }
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
