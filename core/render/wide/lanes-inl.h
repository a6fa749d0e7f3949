/// @file
/// Vectors of floats and of directions, one path in each lane (Highway; for
/// inclusion per target). The scalar operations in the scalar order: a lane
/// holds what the scalar code would, bit for bit.

// Highway's guard, which flips with each target, in place of #pragma once.
#if defined(RTB_CORE_RENDER_WIDE_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTB_CORE_RENDER_WIDE_LANES_INL_H_
#undef RTB_CORE_RENDER_WIDE_LANES_INL_H_
#else
#define RTB_CORE_RENDER_WIDE_LANES_INL_H_
#endif

#include <hwy/highway.h>

#include <cstdint>

#include "core/math/vec.h"

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {
namespace wide {
namespace hn = hwy::HWY_NAMESPACE;

using DF = hn::CappedTag<float, 16>;
using DI = hn::RebindToSigned<DF>;
using DU = hn::RebindToUnsigned<DF>;
using F = hn::Vec<DF>;
using I = hn::Vec<DI>;
using U = hn::Vec<DU>;
using M = hn::Mask<DF>;

#if HWY_TARGET == HWY_SCALAR
using DD = hn::Rebind<double, DF>;
#else
using DD = hn::Rebind<double, hn::Half<DF>>;
#endif
/// Double precision, for half of the lanes.
using D = hn::Vec<DD>;

#if HWY_TARGET == HWY_SCALAR  // A lane has no halves: both are the lane.
HWY_INLINE D LowerDoubles(F v) { return hn::PromoteTo(DD(), v); }
HWY_INLINE D UpperDoubles(F v) { return hn::PromoteTo(DD(), v); }
HWY_INLINE F Floats(D lower, D) { return hn::DemoteTo(DF(), lower); }
#else
HWY_INLINE D LowerDoubles(F v) {
  return hn::PromoteTo(DD(), hn::LowerHalf(hn::Half<DF>(), v));
}
HWY_INLINE D UpperDoubles(F v) {
  return hn::PromoteTo(DD(), hn::UpperHalf(hn::Half<DF>(), v));
}
HWY_INLINE F Floats(D lower, D upper) {
  const hn::Half<DF> half;
  return hn::Combine(DF(), hn::DemoteTo(half, upper),
                     hn::DemoteTo(half, lower));
}
#endif

HWY_INLINE F Set(float value) { return hn::Set(DF(), value); }
HWY_INLINE U SetU(std::uint32_t value) { return hn::Set(DU(), value); }
/// Something to divide by more than once.
struct Divisor {
  explicit Divisor(F v) : value(v), inverse(hn::Set(DF(), 1) / v) {}
  explicit Divisor(float v)
      : value(hn::Set(DF(), v)), inverse(hn::Set(DF(), 1 / v)) {}
  F value, inverse;
};

/// a / b, rounded as a division rounds it, at the cost of products: the
/// remainder of a quotient, which is exact, corrects it; done twice, the
/// quotient is within one unit before the last step, so that this one rounds
/// correctly (Markstein, "Computation of Elementary Functions on the IBM RISC
/// System/6000 Processor", IBM J. Res. Dev. 34(1), 1990, theorem 5). Only where
/// |a| < 2^-100 the last bit may differ, since the remainder is lost.
HWY_INLINE F operator/(F a, const Divisor& b) {
#if HWY_NATIVE_FMA
  F quotient = a * b.inverse;
  for (int step = 0; step < 2; ++step) {
    const F rest = hn::NegMulAdd(quotient, b.value, a);
    quotient = hn::MulAdd(rest, b.inverse, quotient);
  }
  return quotient;
#else
  return a / b.value;
#endif
}

HWY_INLINE F Select(M mask, F yes, F no) {
  return hn::IfThenElse(mask, yes, no);
}
HWY_INLINE bool Any(M mask) { return !hn::AllFalse(DF(), mask); }
HWY_INLINE std::uint64_t Count(M mask) { return hn::CountTrue(DF(), mask); }
HWY_INLINE M None() { return hn::FirstN(DF(), 0); }

/// Entry `index` of a table of 16, in each lane.
HWY_INLINE F LookUp(const float* table, I index) {
  if constexpr (HWY_MAX_BYTES == 64) {
    return hn::TableLookupLanes(hn::Load(DF(), table),
                                hn::IndicesFromVec(DF(), index));
  } else {
    return hn::GatherIndex(DF(), table, index);
  }
}

/// A direction, point or color in each lane.
struct V3 {
  F x, y, z;
};

HWY_INLINE V3 Set(const V3f& v) { return {Set(v.x), Set(v.y), Set(v.z)}; }
HWY_INLINE V3 operator+(const V3& a, const V3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
HWY_INLINE V3 operator-(const V3& a, const V3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
HWY_INLINE V3 operator*(const V3& a, const V3& b) {
  return {a.x * b.x, a.y * b.y, a.z * b.z};
}
HWY_INLINE V3 operator*(const V3& a, F s) {
  return {a.x * s, a.y * s, a.z * s};
}
HWY_INLINE V3 operator/(const V3& a, const Divisor& s) {
  return {a.x / s, a.y / s, a.z / s};
}
HWY_INLINE V3 operator-(const V3& a) {
  return {hn::Neg(a.x), hn::Neg(a.y), hn::Neg(a.z)};
}
HWY_INLINE F Dot(const V3& a, const V3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
HWY_INLINE V3 Select(M mask, const V3& yes, const V3& no) {
  return {Select(mask, yes.x, no.x), Select(mask, yes.y, no.y),
          Select(mask, yes.z, no.z)};
}
HWY_INLINE F MaxAbs(const V3& v) {
  return hn::Max(hn::Max(hn::Abs(v.x), hn::Abs(v.y)), hn::Abs(v.z));
}
/// The largest component.
HWY_INLINE F Largest(const V3& v) { return hn::Max(v.x, hn::Max(v.y, v.z)); }
HWY_INLINE M IsBlack(const V3& v) {
  const F zero = hn::Zero(DF());
  return hn::And(hn::And(v.x == zero, v.y == zero), v.z == zero);
}
HWY_INLINE V3 Normalized(const V3& v) {
  const F length = hn::Sqrt(Dot(v, v));
  const M some = length != hn::Zero(DF());
  const V3 unit = v / Divisor(length);
  return {hn::IfThenElseZero(some, unit.x), hn::IfThenElseZero(some, unit.y),
          hn::IfThenElseZero(some, unit.z)};
}
HWY_INLINE V3 LookUp(const float (&table)[3][16], I index) {
  return {LookUp(table[0], index), LookUp(table[1], index),
          LookUp(table[2], index)};
}

/// Affine's linear part.
struct Linear {
  V3 x, y, z;
};
HWY_INLINE V3 Apply(const Linear& m, const V3& v) {
  return m.x * v.x + m.y * v.y + m.z * v.z;
}
HWY_INLINE V3 Transposed(const Linear& m, const V3& n) {
  return {Dot(m.x, n), Dot(m.y, n), Dot(m.z, n)};
}

/// TangentsOf (core/math/frame.h) with the normal itself: a frame.
struct LaneFrame {
  V3 s, t, n;
};
HWY_INLINE LaneFrame FrameOf(const V3& n) {
  const F one = Set(1);
  const F sign = hn::CopySign(one, n.z);
  const F a = Set(-1) / (sign + n.z);
  const F b = n.x * n.y * a;
  return {{one + sign * n.x * n.x * a, sign * b, hn::Neg(sign) * n.x},
          {b, sign + n.y * n.y * a, hn::Neg(n.y)},
          n};
}
HWY_INLINE V3 ToLocal(const LaneFrame& frame, const V3& v) {
  return {Dot(v, frame.s), Dot(v, frame.t), Dot(v, frame.n)};
}
HWY_INLINE V3 ToWorld(const LaneFrame& frame, const V3& v) {
  return Normalized(frame.s * v.x + frame.t * v.y + frame.n * v.z);
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace wide
}  // namespace HWY_NAMESPACE
}  // namespace rtb
HWY_AFTER_NAMESPACE();

#endif  // RTB_CORE_RENDER_WIDE_LANES_INL_H_
