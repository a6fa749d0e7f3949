/// @file
/// The sRGB transfer on vectors, for inclusion per target (Highway). Includers
/// come after `#include <hwy/highway.h>`. Results equal srgb.h's bit for bit:
/// products and sums are never fused.

// Highway's guard, which flips with each target, in place of #pragma once.
#if defined(RTB_CORE_COLOR_SRGB_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTB_CORE_COLOR_SRGB_INL_H_
#undef RTB_CORE_COLOR_SRGB_INL_H_
#else
#define RTB_CORE_COLOR_SRGB_INL_H_
#endif

#include <hwy/highway.h>

#include "core/color/srgb_tables.h"

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// 8-bit codes of linear values, one in each 32-bit lane.
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Vec<hn::RebindToSigned<D>> SrgbCodesOf(
    D d, V linear, const SrgbCodeTable& table) {
  const hn::RebindToSigned<D> di;
  const hn::RebindToUnsigned<D> du;
  // The comparison is false for NaN, which becomes black.
  const V darkest = hn::Set(d, SrgbCodeTable::kDarkest);
  const V x = hn::Min(hn::IfThenElse(hn::Gt(linear, darkest), linear, darkest),
                      hn::Set(d, 1));
  const auto bits = hn::BitCast(du, x);
  const auto bucket = hn::Sub(hn::ShiftRight<SrgbCodeTable::kShift>(bits),
                              hn::Set(du, SrgbCodeTable::kFirstBucket));
  const auto entry =
      hn::GatherIndex(du, table.entries.data(), hn::BitCast(di, bucket));
  const auto rest = hn::And(bits, hn::Set(du, SrgbCodeTable::kRest));
  return hn::BitCast(
      di, hn::ShiftRight<SrgbCodeTable::kShift>(hn::Add(entry, rest)));
}

/// 1 / first, for a mantissa of 4 bits, which `leading` ends on. The table
/// holds rounded quotients, so both ways give the same; vectors of 16 lanes
/// hold all of it.
template <class D, class V, class VI>
HWY_INLINE V ReciprocalOf(D d, V first, VI leading,
                          const SrgbCurveTable& table) {
  if constexpr (HWY_MAX_BYTES == 64) {
    const hn::RebindToSigned<D> di;
    const VI place = hn::And(leading, hn::Set(di, 15));
    return hn::TableLookupLanes(hn::Load(d, table.reciprocal.data()),
                                hn::IndicesFromVec(d, place));
  } else {
    return hn::Div(hn::Set(d, 1), first);
  }
}

/// Encoded values of linear ones, unrounded.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V SrgbCurveOf(D d, V linear, const SrgbCurveTable& table) {
  using T = SrgbCurveTable;
  const hn::RebindToSigned<D> di;
  const V one = hn::Set(d, 1);
  const V zero = hn::Zero(d);
  // The comparison is false for NaN, which becomes 0.
  const V x = hn::Min(hn::IfThenElse(hn::Gt(linear, zero), linear, zero), one);
  const V low = hn::Mul(hn::Set(d, T::kSlope), x);
  const V high_x = hn::Max(x, hn::Set(d, 0x1p-9f));
  const auto bits = hn::BitCast(di, high_x);
  const auto leading = hn::ShiftRight<T::kShift>(bits);
  const V start = hn::GatherIndex(
      d, table.start.data(),
      hn::Sub(leading, hn::Set(di, static_cast<int>(T::kFirstBucket))));
  // The mantissa less the bucket's first, exactly.
  const auto one_bits = hn::BitCast(di, one);
  const auto mantissa = hn::Or(hn::And(bits, hn::Set(di, 0x7fffff)), one_bits);
  const auto first_bits =
      hn::AndNot(hn::Set(di, (1 << T::kShift) - 1), mantissa);
  const V first = hn::BitCast(d, first_bits);
  const V e = hn::Mul(hn::Sub(hn::BitCast(d, mantissa), first),
                      ReciprocalOf(d, first, leading, table));
  const V c = hn::Add(
      hn::Mul(hn::Add(hn::Mul(hn::Set(d, T::kC3), e), hn::Set(d, T::kC2)), e),
      hn::Set(d, T::kC1));
  const V rise = hn::Mul(hn::Add(start, hn::Set(d, T::kOffset)), hn::Mul(c, e));
  const V high = hn::Add(start, rise);
  return hn::IfThenElse(hn::Gt(x, hn::Set(d, T::kKnee)), high, low);
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace rtb
HWY_AFTER_NAMESPACE();

#endif  // RTB_CORE_COLOR_SRGB_INL_H_
