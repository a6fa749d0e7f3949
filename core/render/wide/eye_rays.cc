#include "core/render/wide/eye_rays.h"

// This file is compiled once for each target.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/render/wide/eye_rays.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/render/wide/jitter-inl.h"
#include "core/render/wide/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {
namespace wide {

/// Stores places in one direction of the picture.
HWY_INLINE void StorePlaces(double base, F offset, double* places) {
  const D start = hn::Set(DD(), base);
  hn::StoreU(start + LowerDoubles(offset), DD(), places);
  if constexpr (HWY_TARGET != HWY_SCALAR) {
    hn::StoreU(start + UpperDoubles(offset), DD(), places + hn::Lanes(DD()));
  }
}

struct D3 {
  D x, y, z;
};

HWY_INLINE D3 Along(const V3d& v, D s) {
  return {hn::Set(DD(), v.x) * s, hn::Set(DD(), v.y) * s,
          hn::Set(DD(), v.z) * s};
}
HWY_INLINE D3 Sum(const D3& a, const D3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

/// EyeRay's direction, for half of the lanes.
HWY_INLINE D3 DirectionsOf(const CameraRays& camera, const GridSize& grid,
                           const double* x, const double* y) {
  const D one = hn::Set(DD(), 1), two = hn::Set(DD(), 2);
  const D u = hn::LoadU(DD(), x) / hn::Set(DD(), grid.columns);
  const D v = hn::LoadU(DD(), y) / hn::Set(DD(), grid.rows);
  const D3 d =
      Sum(Sum(Along(camera.forward, one), Along(camera.right, two * u - one)),
          Along(camera.up, one - two * v));
  const D length = hn::Sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
  return {d.x / length, d.y / length, d.z / length};
}

HWY_INLINE void MakeRays(const CameraRays& camera, const GridSize& grid,
                         int first, Paths* paths) {
  const double* x = paths->x + first;
  const double* y = paths->y + first;
  const std::size_t half = HWY_TARGET == HWY_SCALAR ? 0 : hn::Lanes(DD());
  const D3 lower = DirectionsOf(camera, grid, x, y);
  const D3 upper = DirectionsOf(camera, grid, x + half, y + half);
  hn::StoreU(Floats(lower.x, upper.x), DF(), paths->direction[0] + first);
  hn::StoreU(Floats(lower.y, upper.y), DF(), paths->direction[1] + first);
  hn::StoreU(Floats(lower.z, upper.z), DF(), paths->direction[2] + first);
  const V3f origin(camera.position);
  for (int axis = 0; axis < 3; ++axis) {
    hn::StoreU(Set(origin[axis]), DF(), paths->origin[axis] + first);
  }
}

}  // namespace wide

void PlaceEyesOn(const EyeSet& set, std::uint32_t first, int count, int place,
                 Paths* paths) {
  using namespace wide;  // NOLINT(google-build-using-namespace)
  const Jitter jitter(set.count, set.pattern);
  const auto lanes = static_cast<int>(hn::Lanes(DF()));
  for (int i = 0; i < count; i += lanes) {
    // Those past the last repeat it.
    const U index =
        hn::Min(hn::Iota(DU(), first + static_cast<std::uint32_t>(i)),
                SetU(set.count - 1));
    const Jitter::Position unit = jitter.At(index);
    const F half = Set(0.5f);
    StorePlaces(set.position.x, (unit.x - half) * Set(set.footprint.x),
                paths->x + place + i);
    StorePlaces(set.position.y, (unit.y - half) * Set(set.footprint.y),
                paths->y + place + i);
    hn::StoreU(index, DU(), paths->index + place + i);
    hn::StoreU(SetU(set.pattern), DU(), paths->pattern + place + i);
  }
}

void MakeEyeRaysOn(const CameraRays& camera, const GridSize& grid,
                   Paths* paths) {
  const auto lanes = static_cast<int>(hwy::HWY_NAMESPACE::Lanes(wide::DF()));
  for (int i = 0; i < paths->count; i += lanes) {
    wide::MakeRays(camera, grid, i, paths);
  }
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace rtb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtb {

HWY_EXPORT(PlaceEyesOn);
HWY_EXPORT(MakeEyeRaysOn);

void PlaceEyes(const EyeSet& set, std::uint32_t first, int count, int place,
               Paths* paths) {
  if (set.count > 1) {
    HWY_DYNAMIC_DISPATCH(PlaceEyesOn)(set, first, count, place, paths);
    return;
  }
  paths->x[place] = set.position.x;
  paths->y[place] = set.position.y;
  paths->index[place] = 0;
  paths->pattern[place] = set.pattern;
}

void MakeEyeRays(const CameraRays& camera, const GridSize& grid, Paths* paths) {
  HWY_DYNAMIC_DISPATCH(MakeEyeRaysOn)(camera, grid, paths);
}

}  // namespace rtb
#endif  // HWY_ONCE
