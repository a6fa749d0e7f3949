/// @file
/// The two queries that a walk through a BvhView answers.
#pragma once

#include "core/accel/bvh_blocked.h"
#include "core/accel/bvh_closest.h"
#include "core/base/host_device.h"

namespace rtb {

/// The closest hit on (0, ray.t_max).
template <class Lanes>
RTB_HD_CALLED Hit ClosestInBvh(const BvhView& view, const Ray& ray) {
  Hit hit;
  if (!IsTraceable(ray)) return hit;
  IntersectPlanes(view.geometry, ray, &hit);
  float t_max = hit.kind == PrimitiveKind::kNothing ? ray.t_max : hit.t;
  ClosestInPart<Lanes> leaf(view, ray, &hit, &t_max);
  for (int part = 0; part < 2; ++part) {
    const BvhTables& tables = part == 0 ? view.still : view.moving;
    leaf.Enter(tables);
    WalkBvh<Lanes>(tables.nodes, part == 0 ? view.still_root : view.moving_root,
                   ray.origin, ray.direction, &leaf);
  }
  return hit;
}

/// Finds out whether something blocks a ray.
template <class Lanes>
RTB_HD_CALLED void CrossBvh(const BvhView& view, const Ray& ray,
                            BvhCrossing* crossing) {
  if (!IsTraceable(ray)) return;
  const auto cross = [&](int object) { return crossing->Cross(view, object); };
  if (BlockedByPlanes(view.geometry, ray, cross)) return;
  BlockedInPart<Lanes> leaf(view, ray, crossing);
  for (int part = 0; part < 2 && !crossing->blocked; ++part) {
    const BvhTables& tables = part == 0 ? view.still : view.moving;
    leaf.Enter(tables);
    WalkBvh<Lanes>(tables.nodes, part == 0 ? view.still_root : view.moving_root,
                   ray.origin, ray.direction, &leaf);
  }
}

}  // namespace rtb
