/// @file
/// What a ray needs to be tested against boxes and triangles, made once for
/// each tree that it enters.
#pragma once

#include <cmath>

#include "core/accel/bvh_view.h"
#include "core/accel/ray.h"
#include "core/base/host_device.h"

namespace rtb {

/// A ray made ready for triangles: Woop, Benthin and Wald, "Watertight
/// Ray/Triangle Intersection", JCGT 2(1), 2013, section 3.2: a permutation of
/// the axes that makes z the longest of the direction, and the shear that
/// makes it the z axis.
struct ShearedRay {
  int kx, ky, kz;
  float origin[3];  ///< Permuted.
  float sx, sy;     ///< The shear.

  RTB_HD ShearedRay(const V3f& from, const V3f& direction) {
    const float x = std::abs(direction.x);
    const float y = std::abs(direction.y);
    const float z = std::abs(direction.z);
    kz = x > y ? (x > z ? 0 : 2) : (y > z ? 1 : 2);
    kx = kz == 2 ? 0 : kz + 1;
    ky = kx == 2 ? 0 : kx + 1;
    const float o[3] = {from.x, from.y, from.z};
    const float d[3] = {direction.x, direction.y, direction.z};
    origin[0] = o[kx];
    origin[1] = o[ky];
    origin[2] = o[kz];
    sx = d[kx] / d[kz];
    sy = d[ky] / d[kz];
  }
};

/// A ray made ready for boxes so that none is missed that holds a triangle
/// which ShearedRay's test finds: Woop, Benthin and Wald, section 3.3. The
/// origin is moved away from the planes by a bound of the shear's rounding
/// errors over the whole tree, and the reciprocal direction is rounded so that
/// distances to near planes are too short and those to far planes too long.
struct BoxRay {
  int near_plane[3];  ///< Into BvhNode::bounds; the far one is the other.
  float near_origin[3], far_origin[3];
  float near_scale[3], far_scale[3];

  RTB_HD BoxRay(const BvhRoot& root, const V3f& from, const V3f& direction) {
    // Distances within which the tree lies.
    float reach[3];
    for (int axis = 0; axis < 3; ++axis) {
      const float below = std::abs(from[axis] - root.lower[axis]);
      const float above = std::abs(from[axis] - root.upper[axis]);
      reach[axis] = below > above ? below : above;
    }
    const float x = std::abs(direction.x);
    const float y = std::abs(direction.y);
    const float z = std::abs(direction.z);
    const float along =
        x > y ? (x > z ? reach[0] : reach[2]) : (y > z ? reach[1] : reach[2]);
    for (int axis = 0; axis < 3; ++axis) {
      // Five roundings of half a unit in the last place, and this sum's own.
      const float margin = 6 * 0x1p-24f * (reach[axis] + along);
      SetAxis(axis, from[axis], direction[axis], margin);
    }
  }

 private:
  RTB_HD void SetAxis(int axis, float from, float slope, float margin) {
    // Nothing smaller has a finite reciprocal that single precision can
    // multiply with coordinates.
    constexpr float kSteepest = 1e-18f;
    const float size =
        std::abs(slope) > kSteepest ? std::abs(slope) : kSteepest;
    const float scale = std::copysign(1 / size, slope);
    const bool backwards = std::signbit(slope);
    near_plane[axis] = 2 * axis + (backwards ? 1 : 0);
    near_origin[axis] = backwards ? from - margin : from + margin;
    far_origin[axis] = backwards ? from + margin : from - margin;
    near_scale[axis] = scale * (1 - 0x1p-22f);
    far_scale[axis] = scale * (1 + 0x1p-22f);
  }
};

/// Whether a ray has an origin and a direction: all finite, and not zero.
RTB_HD inline bool IsTraceable(const Ray& ray) {
  const V3f& o = ray.origin;
  const V3f& d = ray.direction;
  // NaN and infinity times zero are NaN.
  const float none = (o.x + o.y + o.z + d.x + d.y + d.z) * 0;
  const float length2 = d.x * d.x + d.y * d.y + d.z * d.z;
  return none == 0 && length2 > 0 && ray.t_max > 0;
}

}  // namespace rtb
