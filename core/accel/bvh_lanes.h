/// @file
/// The two tests that a walk through a BVH consists of: one ray against the
/// boxes of a node, and against the triangles of a pack. Plain loops of fixed
/// width over arrays.
#pragma once

#include "core/accel/bvh_ray.h"
#include "core/accel/bvh_view.h"
#include "core/base/host_device.h"

namespace rtb {

/// What a ray finds in a pack; bit i stands for triangle i, whose corners'
/// weights add up to anything but 0.
struct PackHits {
  unsigned hits = 0;       ///< Met by the ray's line.
  unsigned uncertain = 0;  ///< On an edge as far as single precision tells.
  float weight[3][kPackWidth];
};

/// The tests in portable code. Others must give the same bits.
struct PortableLanes {
  /// The boxes that the ray meets on [0, t_max], as bits; t receives where it
  /// enters each. Robust, see BoxRay.
  RTB_HD static unsigned MeetBoxes(const BvhNode& node, const BoxRay& ray,
                                   float t_max, float* t) {
    unsigned met = 0;
    for (int i = 0; i < kBvhWidth; ++i) {
      float entry = 0;
      float exit = t_max;
      for (int axis = 0; axis < 3; ++axis) {
        const int near = ray.near_plane[axis];
        const float t0 = (node.bounds[near][i] - ray.near_origin[axis]) *
                         ray.near_scale[axis];
        const float t1 = (node.bounds[near ^ 1][i] - ray.far_origin[axis]) *
                         ray.far_scale[axis];
        entry = t0 > entry ? t0 : entry;
        exit = t1 < exit ? t1 : exit;
      }
      t[i] = entry;
      met |= (entry <= exit ? 1u : 0u) << i;
    }
    return met;
  }

  /// The triangles of a pack that the ray's line meets: Woop, Benthin and
  /// Wald, section 3.2, whatever the side.
  RTB_HD static void MeetTriangles(const TrianglePack& pack,
                                   const ShearedRay& ray, PackHits* found) {
    found->hits = found->uncertain = 0;
    for (int i = 0; i < kPackWidth; ++i) {
      const PlanePoint a = Shear(pack.corner[0], ray, i);
      const PlanePoint b = Shear(pack.corner[1], ray, i);
      const PlanePoint c = Shear(pack.corner[2], ray, i);
      const float u = c.x * b.y - c.y * b.x;
      const float v = a.x * c.y - a.y * c.x;
      const float w = b.x * a.y - b.y * a.x;
      const bool inside =
          (u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0);
      const bool zero = u == 0 || v == 0 || w == 0;
      found->weight[0][i] = u;
      found->weight[1][i] = v;
      found->weight[2][i] = w;
      found->hits |= (inside ? 1u : 0u) << i;
      found->uncertain |= (zero ? 1u : 0u) << i;
    }
  }

  /// The same for triangle i alone with products in double precision, where
  /// they are exact: which side of an edge the ray passes is then the same for
  /// both triangles that share it.
  RTB_HD static void MeetExactly(const TrianglePack& pack,
                                 const ShearedRay& ray, int i,
                                 PackHits* found) {
    const PlanePoint a = Shear(pack.corner[0], ray, i);
    const PlanePoint b = Shear(pack.corner[1], ray, i);
    const PlanePoint c = Shear(pack.corner[2], ray, i);
    const double u = Cross(c, b);
    const double v = Cross(a, c);
    const double w = Cross(b, a);
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return;
    const double sum = u + v + w;
    if (sum == 0) return;
    found->weight[0][i] = static_cast<float>(u / sum);
    found->weight[1][i] = static_cast<float>(v / sum);
    found->weight[2][i] = static_cast<float>(w / sum);
    found->hits |= 1u << i;
  }

 private:
  /// Where the sheared ray, which is the z axis, sees a corner.
  struct PlanePoint {
    float x, y;
  };

  RTB_HD static PlanePoint Shear(const float (&corner)[3][kPackWidth],
                                 const ShearedRay& ray, int i) {
    const float z = corner[ray.kz][i] - ray.origin[2];
    return {corner[ray.kx][i] - ray.origin[0] - ray.sx * z,
            corner[ray.ky][i] - ray.origin[1] - ray.sy * z};
  }

  RTB_HD static double Cross(const PlanePoint& p, const PlanePoint& q) {
    return double{p.x} * q.y - double{p.y} * q.x;
  }
};

/// Where the ray meets the plane of triangle i of a pack; NaN or infinity
/// where it does not. The weights would tell too, but their sum over the
/// corners' distances rounds by what the farthest corner is away, and rays
/// that leave a long triangle would meet it again. The plane is taken through
/// the corner between the two shorter edges: the rounding of their cross
/// product is the smallest.
RTB_HD inline float PlaneDistance(const TrianglePack& pack, int i,
                                  const V3f& origin, const V3f& direction) {
  V3f corner[3] = {V3f(0), V3f(0), V3f(0)};
  for (int k = 0; k < 3; ++k) {
    corner[k] =
        V3f(pack.corner[k][0][i], pack.corner[k][1][i], pack.corner[k][2][i]);
  }
  const V3f ab = corner[1] - corner[0];
  const V3f bc = corner[2] - corner[1];
  const V3f ca = corner[0] - corner[2];
  const float ab2 = ab.dot(ab), bc2 = bc.dot(bc), ca2 = ca.dot(ca);
  const bool at_a = bc2 >= ab2 && bc2 >= ca2;
  const bool at_b = !at_a && ca2 >= ab2;
  const V3f normal = at_a ? ca.cross(ab) : at_b ? ab.cross(bc) : bc.cross(ca);
  const V3f from = corner[at_a ? 0 : at_b ? 1 : 2] - origin;
  return normal.dot(from) / normal.dot(direction);
}

}  // namespace rtb
