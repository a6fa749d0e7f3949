/// @file
/// What the walks through a BVH look for: the closest hit, or anything that
/// blocks. Each is a tree's leaf visitor; that of a placed mesh walks the
/// mesh's tree in turn.
#pragma once

#include "core/accel/bvh_lanes.h"
#include "core/accel/bvh_walk.h"
#include "core/accel/intersect.h"
#include "core/base/host_device.h"

namespace rtb {

/// A ray as the triangles of one tree meet it, in the tree's coordinates.
struct TriangleRay {
  const V3f origin;
  const V3f direction;
  const ShearedRay sheared;

  RTB_HD TriangleRay(const V3f& from, const V3f& along)
      : origin(from), direction(along), sheared(from, along) {}
};

/// Triangles of a leaf that the ray meets on (0, t_max).
/// @param meet called with the pack, what was found in it, which triangle and
/// where on the ray; returns whether to stop.
template <class Lanes, class Meet>
RTB_HD bool ForEachTriangle(const TrianglePack* packs, BvhRef ref,
                            const TriangleRay& ray, const float& t_max,
                            const Meet& meet) {
  for (std::uint32_t k = 0; k < ref.count(); ++k) {
    const TrianglePack& pack = packs[ref.index() + k];
    PackHits found;
    Lanes::MeetTriangles(pack, ray.sheared, &found);
    for (unsigned rest = found.uncertain; rest != 0; rest &= rest - 1) {
      PortableLanes::MeetExactly(pack, ray.sheared, LowestBit(rest), &found);
    }
    for (unsigned rest = found.hits; rest != 0; rest &= rest - 1) {
      const int i = LowestBit(rest);
      const float t = PlaneDistance(pack, i, ray.origin, ray.direction);
      if (t > 0 && t < t_max && meet(pack, found, i, t)) return true;
    }
  }
  return false;
}

/// The closest hit among triangles of one table.
template <class Lanes>
class ClosestTriangle {
 public:
  static constexpr bool kNearFirst = true;

  /// @param kind kTriangle or kMesh.
  /// @param use which placed mesh, -1 = none.
  RTB_HD ClosestTriangle(const TrianglePack* packs, const V3f& from,
                         const V3f& direction, PrimitiveKind kind, int use,
                         Hit* hit, float* t_max)
      : packs_(packs),
        ray_(from, direction),
        kind_(kind),
        use_(use),
        hit_(hit),
        t_max_(t_max) {}

  /// Goes on in another table.
  RTB_HD void Enter(const TrianglePack* packs) { packs_ = packs; }
  RTB_HD float t_max() const { return *t_max_; }
  RTB_HD bool Visit(BvhRef ref) {
    return ForEachTriangle<Lanes>(
        packs_, ref, ray_, *t_max_,
        [this](const TrianglePack& pack, const PackHits& found, int i,
               float t) {
          const float u = found.weight[0][i], v = found.weight[1][i];
          const float w = found.weight[2][i];
          const float scale = 1 / (u + v + w);
          *t_max_ = t;
          *hit_ = {kind_, static_cast<int>(pack.id[i]), t, v * scale, w * scale,
                   use_};
          return false;
        });
  }

 private:
  const TrianglePack* packs_;
  const TriangleRay ray_;
  const PrimitiveKind kind_;
  const int use_;
  Hit* hit_;
  float* t_max_;
};

/// The closest hit in the tree of what stands still, or of what moves.
template <class Lanes>
class ClosestInPart {
 public:
  static constexpr bool kNearFirst = true;

  RTB_HD ClosestInPart(const BvhView& view, const Ray& ray, Hit* hit,
                       float* t_max)
      : view_(view),
        ray_(ray),
        triangles_(nullptr, ray.origin, ray.direction, PrimitiveKind::kTriangle,
                   -1, hit, t_max),
        hit_(hit),
        t_max_(t_max) {}

  /// Goes on in another part.
  RTB_HD void Enter(const BvhTables& tables) { triangles_.Enter(tables.packs); }
  RTB_HD float t_max() const { return *t_max_; }
  RTB_HD bool Visit(BvhRef ref) {
    const int index = static_cast<int>(ref.index());
    switch (ref.kind()) {
      case BvhKind::kTriangles:
        return triangles_.Visit(ref);
      case BvhKind::kSphere:
        Take(PrimitiveKind::kSphere, index,
             IntersectSphere(view_.geometry.spheres[index], ray_.origin,
                             ray_.direction));
        return false;
      case BvhKind::kDisk:
        Take(PrimitiveKind::kDisk, index,
             IntersectDisk(view_.geometry.disks[index], ray_.origin,
                           ray_.direction));
        return false;
      default:
        VisitMesh(index);
        return false;
    }
  }

 private:
  RTB_HD void Take(PrimitiveKind kind, int index, const Roots& roots) {
    for (int k = 0; k < roots.count; ++k) {
      if (!(roots.t[k] > 0)) continue;
      if (!(roots.t[k] < *t_max_)) return;
      *t_max_ = roots.t[k];
      *hit_ = {kind, index, roots.t[k], 0, 0, -1};
      return;
    }
  }

  RTB_HD void VisitMesh(int index) {
    const MeshUse& use = view_.geometry.uses[index];
    const Affinef& inverse = view_.geometry.objects[use.object].world_to_object;
    const V3f from = inverse.Point(ray_.origin);
    const V3f direction = inverse.Direction(ray_.direction);
    ClosestTriangle<Lanes> leaf(view_.meshes.packs, from, direction,
                                PrimitiveKind::kMesh, index, hit_, t_max_);
    WalkBvh<Lanes>(view_.meshes.nodes, view_.mesh_roots[use.mesh], from,
                   direction, &leaf);
  }

  const BvhView& view_;
  const Ray& ray_;
  ClosestTriangle<Lanes> triangles_;
  Hit* hit_;
  float* t_max_;
};

/// What a shadow ray's light meets.
struct BvhCrossing {
  bool opaque = false;   ///< Nothing counts as transparent.
  bool crossed = false;  ///< It met something transparent.
  bool blocked = false;

  /// Notes that an object is met. @return whether that blocks the light.
  RTB_HD bool Cross(const BvhView& view, int object) {
    if (opaque || view.transmittance[object] == Rgb(0)) {
      blocked = true;
    } else {
      crossed = true;
    }
    return blocked;
  }
};

/// Whether anything of a mesh is met.
template <class Lanes>
class AnyTriangle {
 public:
  static constexpr bool kNearFirst = false;

  RTB_HD AnyTriangle(const TrianglePack* packs, const V3f& from,
                     const V3f& direction, float t_max)
      : packs_(packs), ray_(from, direction), t_max_(t_max) {}

  RTB_HD float t_max() const { return t_max_; }
  RTB_HD bool Visit(BvhRef ref) {
    met_ = ForEachTriangle<Lanes>(
        packs_, ref, ray_, t_max_,
        [](const TrianglePack&, const PackHits&, int, float) { return true; });
    return met_;
  }
  RTB_HD bool met() const { return met_; }

 private:
  const TrianglePack* packs_;
  const TriangleRay ray_;
  const float t_max_;
  bool met_ = false;
};

/// Whether something blocks in the tree of what stands still, or moves.
template <class Lanes>
class BlockedInPart {
 public:
  static constexpr bool kNearFirst = false;

  RTB_HD BlockedInPart(const BvhView& view, const Ray& ray,
                       BvhCrossing* crossing)
      : view_(view),
        ray_(ray),
        triangle_ray_(ray.origin, ray.direction),
        crossing_(crossing) {}

  /// Goes on in another part.
  RTB_HD void Enter(const BvhTables& tables) { packs_ = tables.packs; }
  RTB_HD float t_max() const { return ray_.t_max; }
  RTB_HD bool Visit(BvhRef ref) {
    const int index = static_cast<int>(ref.index());
    switch (ref.kind()) {
      case BvhKind::kTriangles:
        return VisitTriangles(ref);
      case BvhKind::kSphere: {
        const Quadric& sphere = view_.geometry.spheres[index];
        return Take(sphere,
                    IntersectSphere(sphere, ray_.origin, ray_.direction));
      }
      case BvhKind::kDisk: {
        const Quadric& disk = view_.geometry.disks[index];
        return Take(disk, IntersectDisk(disk, ray_.origin, ray_.direction));
      }
      default:
        return VisitMesh(view_.geometry.uses[index]);
    }
  }

 private:
  RTB_HD bool VisitTriangles(BvhRef ref) {
    return ForEachTriangle<Lanes>(
        packs_, ref, triangle_ray_, ray_.t_max,
        [this](const TrianglePack& pack, const PackHits&, int i, float) {
          return crossing_->Cross(view_,
                                  view_.geometry.triangle_objects[pack.id[i]]);
        });
  }

  RTB_HD bool Take(const Quadric& quadric, const Roots& roots) {
    for (int k = 0; k < roots.count; ++k) {
      if (!(roots.t[k] > 0)) continue;
      if (!(roots.t[k] < ray_.t_max)) return false;
      return crossing_->Cross(view_, quadric.object);
    }
    return false;
  }

  RTB_HD bool VisitMesh(const MeshUse& use) {
    const Affinef& inverse = view_.geometry.objects[use.object].world_to_object;
    const V3f from = inverse.Point(ray_.origin);
    const V3f direction = inverse.Direction(ray_.direction);
    AnyTriangle<Lanes> leaf(view_.meshes.packs, from, direction, ray_.t_max);
    WalkBvh<Lanes>(view_.meshes.nodes, view_.mesh_roots[use.mesh], from,
                   direction, &leaf);
    return leaf.met() && crossing_->Cross(view_, use.object);
  }

  const BvhView& view_;
  const TrianglePack* packs_ = nullptr;
  const Ray& ray_;
  const TriangleRay triangle_ray_;
  BvhCrossing* crossing_;
};

/// The closest hit on (0, ray.t_max).
template <class Lanes>
RTB_HD Hit ClosestInBvh(const BvhView& view, const Ray& ray) {
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
RTB_HD void CrossBvh(const BvhView& view, const Ray& ray,
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
