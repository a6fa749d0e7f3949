/// @file
/// The triangles of a BVH's leaf under a ray.
#pragma once

#include "core/accel/bvh_lanes.h"
#include "core/accel/bvh_walk.h"
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

}  // namespace rtb
