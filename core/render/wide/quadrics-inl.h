/// @file
/// intersect.h and surface.h on vectors of rays (Highway; for inclusion per
/// target): rays test every primitive of a WideScene.

// Highway's guard, which flips with each target, in place of #pragma once.
#if defined(RTB_CORE_RENDER_WIDE_QUADRICS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTB_CORE_RENDER_WIDE_QUADRICS_INL_H_
#undef RTB_CORE_RENDER_WIDE_QUADRICS_INL_H_
#else
#define RTB_CORE_RENDER_WIDE_QUADRICS_INL_H_
#endif

#include <hwy/highway.h>

#include <limits>

#include "core/render/wide/lanes-inl.h"
#include "core/render/wide/wide_scene.h"

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {
namespace wide {

/// Where rays meet one primitive, at t > 0; elsewhere `some` is false.
struct Crossing {
  M some;
  F t;
};

HWY_INLINE V3 Column(const float (&rows)[3][16], int i) {
  return {Set(rows[0][i]), Set(rows[1][i]), Set(rows[2][i])};
}

HWY_INLINE Linear ToUnit(const WideScene& scene, int i) {
  return {Column(scene.to_unit[0], i), Column(scene.to_unit[1], i),
          Column(scene.to_unit[2], i)};
}

HWY_INLINE Crossing CrossPlane(const WideScene& scene, int i, const V3& origin,
                               const V3& direction) {
  const V3 normal = Column(scene.normal, i);
  const F slope = Dot(normal, direction);
  const F t = Dot(normal, Column(scene.center, i) - origin) / slope;
  const F zero = hn::Zero(DF());
  return {hn::And(slope != zero, t > zero), t};
}

/// Whether some ray may meet the unit sphere, with room for rounding: it comes
/// nearer than 1, and does not lead away from outside. This costs no division.
/// @param a,b,f2 d . d, -f . d and f . f of rays f + t d.
HWY_INLINE bool MayMeet(F a, F b, F f2) {
  const F room = Set(0x1p-18f);
  const F excess = f2 * a - b * b - a;
  const M near = excess <= f2 * a * room;
  const M ahead = hn::Or(b > hn::Zero(DF()), f2 <= Set(1) + room);
  return Any(hn::And(near, ahead));
}

HWY_INLINE Crossing CrossSphere(const WideScene& scene, int i, const V3& origin,
                                const V3& direction) {
  const F zero = hn::Zero(DF());
  const Linear to_unit = ToUnit(scene, i);
  const V3 f = Apply(to_unit, origin - Column(scene.center, i));
  const V3 d = Apply(to_unit, direction);
  const F a = Dot(d, d);
  const F b = hn::Neg(Dot(f, d));
  const F f2 = Dot(f, f);
  if (!MayMeet(a, b, f2)) return {None(), zero};
  const Divisor by_a(a);
  const V3 nearest = f + d * (b / by_a);
  const F discriminant = a * (Set(1) - Dot(nearest, nearest));
  const M met = discriminant >= zero;
  if (!Any(met)) return {met, zero};
  const F root = hn::Sqrt(discriminant);
  const F q = b + hn::CopySign(root, b);
  const F t0 = (f2 - Set(1)) / q;
  const F t1 = q / by_a;
  const M ordered = t0 < t1;
  const F first = Select(ordered, t0, t1);
  const F t = Select(first > zero, first, Select(ordered, t1, t0));
  return {hn::And(hn::And(met, q != zero), t > zero), t};
}

HWY_INLINE Crossing CrossDisk(const WideScene& scene, int i, const V3& origin,
                              const V3& direction) {
  const F zero = hn::Zero(DF());
  const Linear to_unit = ToUnit(scene, i);
  const V3 f = Apply(to_unit, origin - Column(scene.center, i));
  const V3 d = Apply(to_unit, direction);
  const F t = hn::Neg(f.z) / d.z;
  const F x = f.x + t * d.x;
  const F y = f.y + t * d.y;
  const M inside = x * x + y * y <= Set(1);
  return {hn::And(hn::And(d.z != zero, inside), t > zero), t};
}

/// Calls visit(i, crossing) for every primitive, until it returns false.
template <class Visit>
HWY_INLINE void CrossAll(const WideScene& scene, const V3& origin,
                         const V3& direction, const Visit& visit) {
  const int spheres = scene.planes + scene.spheres;
  int i = 0;
  for (; i < scene.planes; ++i) {
    if (!visit(i, CrossPlane(scene, i, origin, direction))) return;
  }
  for (; i < spheres; ++i) {
    if (!visit(i, CrossSphere(scene, i, origin, direction))) return;
  }
  for (; i < scene.count(); ++i) {
    if (!visit(i, CrossDisk(scene, i, origin, direction))) return;
  }
}

/// The closest crossings.
struct Hits {
  M some;
  F t;
  I primitive;
};

HWY_INLINE Hits ClosestOf(const WideScene& scene, const V3& origin,
                          const V3& direction) {
  Hits hits{None(), Set(std::numeric_limits<float>::infinity()),
            hn::Zero(DI())};
  CrossAll(scene, origin, direction, [&](int i, const Crossing& crossing) {
    const M closer = hn::And(crossing.some, crossing.t < hits.t);
    hits.t = Select(closer, crossing.t, hits.t);
    hits.primitive = hn::IfThenElse(hn::RebindMask(DI(), closer),
                                    hn::Set(DI(), i), hits.primitive);
    hits.some = hn::Or(hits.some, closer);
    return true;
  });
  return hits;
}

/// Which rays meet something.
HWY_INLINE M Occluded(const WideScene& scene, M rays, const V3& origin,
                      const V3& direction) {
  M met = None();
  CrossAll(scene, origin, direction, [&](int, const Crossing& crossing) {
    const F end = Set(std::numeric_limits<float>::infinity());
    met = hn::Or(met, hn::And(crossing.some, crossing.t < end));
    return Any(hn::AndNot(met, rays));
  });
  return met;
}

/// SurfacePoint's position, geometric normal and scale.
struct Points {
  V3 position;
  V3 normal;
  F scale;
};

HWY_INLINE V3 NormalToWorld(const Linear& to_unit, const V3& n) {
  const V3 world = Transposed(to_unit, n);
  return Normalized(world / Divisor(MaxAbs(world)));
}

HWY_INLINE Linear LookUp(const float (&table)[3][3][16], I index) {
  return {LookUp(table[0], index), LookUp(table[1], index),
          LookUp(table[2], index)};
}

HWY_INLINE Points SurfaceOf(const WideScene& scene, const Hits& hits,
                            const V3& origin, const V3& direction) {
  const I i = hits.primitive;
  const M plane = hn::RebindMask(DF(), i < hn::Set(DI(), scene.planes));
  const M round = hn::AndNot(
      plane,
      hn::RebindMask(DF(), i < hn::Set(DI(), scene.planes + scene.spheres)));
  Points points;
  points.normal = LookUp(scene.normal, i);
  points.scale = LookUp(scene.scale, i);
  const V3 center = LookUp(scene.center, i);
  const V3 approximate = origin + direction * hits.t;
  const Linear to_unit = LookUp(scene.to_unit, i);
  V3 unit = Apply(to_unit, approximate - center);
  unit.z = hn::IfThenElseZero(round, unit.z);
  if (Any(hn::And(round, hits.some))) {
    unit = Select(round, Normalized(unit), unit);
    points.normal = Select(round, NormalToWorld(to_unit, unit), points.normal);
  }
  points.position = center + Apply(LookUp(scene.to_world, i), unit);
  if (scene.planes > 0) {
    const F above = Dot(points.normal, approximate - center);
    const V3 position = approximate - points.normal * above;
    points.position = Select(plane, position, points.position);
    points.scale =
        Select(plane, hn::Max(MaxAbs(position), points.scale), points.scale);
  }
  return points;
}

/// LeavingOrigin of ray.h.
HWY_INLINE V3 LeavingOrigin(const Points& from, const V3& direction) {
  const M below = Dot(direction, from.normal) < hn::Zero(DF());
  const F side = Select(below, Set(-1), Set(1));
  return from.position + from.normal * (side * Set(0x1p-20f) * from.scale);
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace wide
}  // namespace HWY_NAMESPACE
}  // namespace rtb
HWY_AFTER_NAMESPACE();

#endif  // RTB_CORE_RENDER_WIDE_QUADRICS_INL_H_
