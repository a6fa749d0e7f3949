/// @file
/// Leaf visitors that look for anything that blocks a ray.
#pragma once

#include "core/accel/bvh_triangles.h"
#include "core/accel/intersect.h"
#include "core/base/host_device.h"

namespace rtb {

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
    return FirstBetween(roots, 0, ray_.t_max) < ray_.t_max &&
           crossing_->Cross(view_, quadric.object);
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

}  // namespace rtb
