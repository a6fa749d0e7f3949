/// @file
/// PortableLanes' tests in AVX2: eight boxes, four triangles at once. The same
/// operations in the same order, and so the same bits.
#pragma once

#ifdef __x86_64__

#include <immintrin.h>

#include "core/accel/bvh_lanes.h"

/// Compiles a function for AVX2, whatever the rest is compiled for.
#define RTB_AVX2 [[gnu::target("avx2,bmi")]]

namespace rtb {

struct Avx2Lanes {
  RTB_AVX2 static unsigned MeetBoxes(const BvhNode& node, const BoxRay& ray,
                                     float t_max, float* t) {
    __m256 entry = _mm256_setzero_ps();
    __m256 exit = _mm256_set1_ps(t_max);
    for (int axis = 0; axis < 3; ++axis) {
      const int near = ray.near_plane[axis];
      const __m256 t0 = Distances(node.bounds[near], ray.near_origin[axis],
                                  ray.near_scale[axis]);
      const __m256 t1 = Distances(node.bounds[near ^ 1], ray.far_origin[axis],
                                  ray.far_scale[axis]);
      // Both give their second operand where the first is not a number.
      entry = _mm256_max_ps(t0, entry);
      exit = _mm256_min_ps(t1, exit);
    }
    _mm256_storeu_ps(t, entry);
    return static_cast<unsigned>(
        _mm256_movemask_ps(_mm256_cmp_ps(entry, exit, _CMP_LE_OQ)));
  }

  RTB_AVX2 static void MeetTriangles(const TrianglePack& pack,
                                     const ShearedRay& ray, PackHits* found) {
    const Corners a(pack.corner[0], ray);
    const Corners b(pack.corner[1], ray);
    const Corners c(pack.corner[2], ray);
    const __m128 u = Cross(c, b), v = Cross(a, c), w = Cross(b, a);
    _mm_storeu_ps(found->weight[0], u);
    _mm_storeu_ps(found->weight[1], v);
    _mm_storeu_ps(found->weight[2], w);
    const __m128 zero = _mm_setzero_ps();
    const __m128 positive =
        _mm_and_ps(_mm_and_ps(_mm_cmpgt_ps(u, zero), _mm_cmpgt_ps(v, zero)),
                   _mm_cmpgt_ps(w, zero));
    const __m128 negative =
        _mm_and_ps(_mm_and_ps(_mm_cmplt_ps(u, zero), _mm_cmplt_ps(v, zero)),
                   _mm_cmplt_ps(w, zero));
    const __m128 none =
        _mm_or_ps(_mm_or_ps(_mm_cmpeq_ps(u, zero), _mm_cmpeq_ps(v, zero)),
                  _mm_cmpeq_ps(w, zero));
    found->hits = Bits(_mm_or_ps(positive, negative));
    found->uncertain = Bits(none);
  }

 private:
  /// Of four triangles: one corner each, as the sheared ray sees it.
  struct Corners {
    __m128 x, y;
    RTB_AVX2 Corners(const float (&corner)[3][kPackWidth],
                     const ShearedRay& ray) {
      const __m128 z = From(corner[ray.kz], ray.origin[2]);
      x = _mm_sub_ps(From(corner[ray.kx], ray.origin[0]),
                     _mm_mul_ps(_mm_set1_ps(ray.sx), z));
      y = _mm_sub_ps(From(corner[ray.ky], ray.origin[1]),
                     _mm_mul_ps(_mm_set1_ps(ray.sy), z));
    }
  };

  RTB_AVX2 static __m128 From(const float* coordinates, float origin) {
    return _mm_sub_ps(_mm_load_ps(coordinates), _mm_set1_ps(origin));
  }
  RTB_AVX2 static __m128 Cross(const Corners& p, const Corners& q) {
    return _mm_sub_ps(_mm_mul_ps(p.x, q.y), _mm_mul_ps(p.y, q.x));
  }
  RTB_AVX2 static unsigned Bits(__m128 mask) {
    return static_cast<unsigned>(_mm_movemask_ps(mask));
  }
  RTB_AVX2 static __m256 Distances(const float* planes, float origin,
                                   float scale) {
    return _mm256_mul_ps(
        _mm256_sub_ps(_mm256_load_ps(planes), _mm256_set1_ps(origin)),
        _mm256_set1_ps(scale));
  }
};

}  // namespace rtb

#endif  // __x86_64__
