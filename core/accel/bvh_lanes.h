/// @file
/// The two tests that a walk through a BVH consists of: one ray against the
/// boxes of a node, and against the triangles of a pack. Plain loops of fixed
/// width over arrays.
#pragma once

#include "core/accel/bvh_ray.h"
#include "core/accel/bvh_view.h"
#include "core/base/host_device.h"

namespace rtb {

/// What a ray finds in a pack; bit i stands for triangle i.
struct PackHits {
  unsigned hits = 0;       ///< Met at t in (0, t_max).
  unsigned uncertain = 0;  ///< On an edge as far as single precision tells.
  float t[kPackWidth];
  float u[kPackWidth];  ///< Weight of the second corner.
  float v[kPackWidth];  ///< Weight of the third corner.
};

/// A corner of a triangle as the sheared ray sees it.
template <class T>
struct ShearedCorner {
  T x, y, z;
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

  /// Woop, Benthin and Wald, section 3.2, for each triangle of a pack.
  RTB_HD static void MeetTriangles(const TrianglePack& pack,
                                   const ShearedRay& ray, float t_max,
                                   PackHits* found) {
    found->hits = found->uncertain = 0;
    for (int i = 0; i < kPackWidth; ++i) {
      const ShearedCorner<float> a = Shear<float>(pack.corner[0], ray, i);
      const ShearedCorner<float> b = Shear<float>(pack.corner[1], ray, i);
      const ShearedCorner<float> c = Shear<float>(pack.corner[2], ray, i);
      const float u = c.x * b.y - c.y * b.x;
      const float v = a.x * c.y - a.y * c.x;
      const float w = b.x * a.y - b.y * a.x;
      const bool zero = u == 0 || v == 0 || w == 0;
      const bool outside =
          (u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0);
      const float scale = 1 / (u + v + w);
      found->t[i] = (u * a.z + v * b.z + w * c.z) * scale;
      found->u[i] = v * scale;
      found->v[i] = w * scale;
      const bool within = found->t[i] > 0 && found->t[i] < t_max;
      found->hits |= (!zero && !outside && within ? 1u : 0u) << i;
      found->uncertain |= (zero ? 1u : 0u) << i;
    }
  }

  /// The same for triangle i alone with products in double precision, where
  /// they are exact: which side of an edge the ray passes is then the same for
  /// both triangles that share it.
  RTB_HD static void MeetExactly(const TrianglePack& pack,
                                 const ShearedRay& ray, float t_max, int i,
                                 PackHits* found) {
    const ShearedCorner<double> a = Shear<double>(pack.corner[0], ray, i);
    const ShearedCorner<double> b = Shear<double>(pack.corner[1], ray, i);
    const ShearedCorner<double> c = Shear<double>(pack.corner[2], ray, i);
    const double u = c.x * b.y - c.y * b.x;
    const double v = a.x * c.y - a.y * c.x;
    const double w = b.x * a.y - b.y * a.x;
    const double sum = u + v + w;
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return;
    if (sum == 0) return;
    found->t[i] = static_cast<float>((u * a.z + v * b.z + w * c.z) / sum);
    found->u[i] = static_cast<float>(v / sum);
    found->v[i] = static_cast<float>(w / sum);
    if (found->t[i] > 0 && found->t[i] < t_max) found->hits |= 1u << i;
  }

 private:
  /// A corner of triangle i; rounded to single precision in any case, so that
  /// triangles that share the corner see the same.
  template <class T>
  RTB_HD static ShearedCorner<T> Shear(const float (&corner)[3][kPackWidth],
                                       const ShearedRay& ray, int i) {
    const float x = corner[ray.kx][i] - ray.origin[0];
    const float y = corner[ray.ky][i] - ray.origin[1];
    const float z = corner[ray.kz][i] - ray.origin[2];
    const float sheared_x = x - ray.sx * z;
    const float sheared_y = y - ray.sy * z;
    const float along = ray.sz * z;
    return {T{sheared_x}, T{sheared_y}, T{along}};
  }
};

}  // namespace rtb
