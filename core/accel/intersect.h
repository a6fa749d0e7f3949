/// @file
/// Ray intersections with analytic primitives, host and device.
#pragma once

#include <cmath>

#include "core/accel/geometry.h"
#include "core/accel/ray.h"
#include "core/base/host_device.h"

namespace rtb {

/// Up to two ray parameters, in increasing order.
struct Roots {
  int count = 0;
  float t[2] = {0, 0};
};

/// The smallest of them between two bounds; `far` where there is none.
RTB_HD inline float FirstBetween(const Roots& roots, float near, float far) {
  for (int k = 0; k < roots.count; ++k) {
    if (roots.t[k] > near) return roots.t[k] < far ? roots.t[k] : far;
  }
  return far;
}

/// Where the line origin + t direction meets a sphere, at any t. After Haines
/// et al., "Precision Improvements for Ray/Sphere Intersection", Ray Tracing
/// Gems, 2019, chapter 7: the discriminant from the distance of the center to
/// the line, the roots without cancellation.
RTB_HD inline Roots IntersectSphere(const Quadric& sphere, const V3f& origin,
                                    const V3f& direction) {
  const V3f f = sphere.to_unit.Direction(origin - sphere.center);
  const V3f d = sphere.to_unit.Direction(direction);
  const float a = d.dot(d);
  const float b = -f.dot(d);
  const V3f nearest = f + d * (b / a);
  const float discriminant = a * (1 - nearest.dot(nearest));
  if (!(discriminant >= 0)) return {};
  const float root = std::sqrt(discriminant);
  const float q = b + std::copysign(root, b);
  const float c = f.dot(f) - 1;
  const float t0 = c / q;
  const float t1 = q / a;
  if (q == 0) return {};
  return t0 < t1 ? Roots{2, {t0, t1}} : Roots{2, {t1, t0}};
}

/// Where the line meets a disk (affine image of the unit disk z = 0).
RTB_HD inline Roots IntersectDisk(const Quadric& disk, const V3f& origin,
                                  const V3f& direction) {
  const V3f f = disk.to_unit.Direction(origin - disk.center);
  const V3f d = disk.to_unit.Direction(direction);
  if (d.z == 0) return {};
  const float t = -f.z / d.z;
  const float x = f.x + t * d.x;
  const float y = f.y + t * d.y;
  if (!(x * x + y * y <= 1)) return {};
  return {1, {t, 0}};
}

/// Where the line meets an infinite plane.
RTB_HD inline Roots IntersectPlane(const PlaneData& plane, const V3f& origin,
                                   const V3f& direction) {
  const float slope = plane.normal.dot(direction);
  if (slope == 0) return {};
  return {1, {plane.normal.dot(plane.point - origin) / slope, 0}};
}

/// The closest plane hit nearer than `hit`, which it replaces.
RTB_HD inline void IntersectPlanes(const GeometryView& geometry, const Ray& ray,
                                   Hit* hit) {
  for (int i = 0; i < geometry.plane_count; ++i) {
    const Roots roots =
        IntersectPlane(geometry.planes[i], ray.origin, ray.direction);
    const float far = ray.t_max < hit->t ? ray.t_max : hit->t;
    const float t = FirstBetween(roots, 0, far);
    if (t < far) *hit = {PrimitiveKind::kPlane, i, t, 0, 0, -1};
  }
}

/// Whether a plane on the ray ends it.
/// @param cross called with the object of each plane that the ray meets;
/// returns whether it blocks the ray.
template <class Cross>
RTB_HD bool BlockedByPlanes(const GeometryView& geometry, const Ray& ray,
                            const Cross& cross) {
  for (int i = 0; i < geometry.plane_count; ++i) {
    const PlaneData& plane = geometry.planes[i];
    const Roots roots = IntersectPlane(plane, ray.origin, ray.direction);
    const bool crossed = FirstBetween(roots, 0, ray.t_max) < ray.t_max;
    if (crossed && cross(plane.object)) return true;
  }
  return false;
}

}  // namespace rtb
