/// @file
/// Leaf visitors that look for the closest hit; that of a placed mesh walks the
/// mesh's tree in turn.
#pragma once

#include "core/accel/bvh_triangles.h"
#include "core/accel/intersect.h"
#include "core/base/host_device.h"

namespace rtb {

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
    const float t = FirstBetween(roots, 0, *t_max_);
    if (!(t < *t_max_)) return;
    *t_max_ = t;
    *hit_ = {kind, index, t, 0, 0, -1};
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

}  // namespace rtb
