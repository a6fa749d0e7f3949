/// @file
/// The two sides of a partition of each cell's samples: their sums, and cells
/// in the colors of their means. For inclusion per target (Highway).

// Highway's guard, which flips with each target, in place of #pragma once.
#if defined(RTB_ENCODERS_SIMD_SIDES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTB_ENCODERS_SIMD_SIDES_INL_H_
#undef RTB_ENCODERS_SIMD_SIDES_INL_H_
#else
#define RTB_ENCODERS_SIMD_SIDES_INL_H_
#endif

#include <hwy/highway.h>

#include "encoders/simd/cells-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {

/// One side of a partition in each lane.
struct Side {
  ColorLanes sum;  ///< Of steps.
  Floats count;    ///< Of samples.
};

/// The samples in the mask, and the others.
template <std::size_t kSamples>
HWY_INLINE void SumSides(const ColorArray<kSamples>& steps, Ints mask,
                         Side& inside, Side& outside) {
  const FloatLanes d;
  const IntLanes di;
  const Floats zero = hn::Zero(d);
  inside = {{zero, zero, zero}, zero};
  ColorLanes total{zero, zero, zero};
  for (std::size_t i = 0; i < kSamples; ++i) {
    const ColorLanes sample = steps[i];
    const auto in = hn::RebindMask(
        d, hn::TestBit(mask, hn::Set(di, 1 << static_cast<int>(i))));
    inside.sum = inside.sum + ColorLanes{hn::IfThenElseZero(in, sample.r),
                                         hn::IfThenElseZero(in, sample.g),
                                         hn::IfThenElseZero(in, sample.b)};
    inside.count = hn::Add(inside.count, hn::IfThenElseZero(in, hn::Set(d, 1)));
    total = total + sample;
  }
  outside = {total - inside.sum,
             hn::Sub(hn::Set(d, static_cast<float>(kSamples)), inside.count)};
}

HWY_INLINE Side SelectSide(FloatMask mask, const Side& yes, const Side& no) {
  return {Select(mask, yes.sum, no.sum),
          hn::IfThenElse(mask, yes.count, no.count)};
}

/// Writes cells of two sides.
HWY_INLINE void StoreSides(const Side& fg, const Side& bg, Ints glyph,
                           Cell* cells) {
  StoreCells(glyph, CodesOfMeans(fg.sum, fg.count),
             CodesOfMeans(bg.sum, bg.count), cells);
}

/// The glyph of each mask.
HWY_INLINE Ints GlyphOf(std::span<const char32_t> glyphs, Ints mask) {
  static_assert(sizeof(char32_t) == sizeof(std::int32_t));
  return hn::GatherIndex(
      IntLanes(), reinterpret_cast<const std::int32_t*>(glyphs.data()), mask);
}

/// The samples of one lane's cell, for the scalar encoders.
template <std::size_t kSamples>
HWY_INLINE std::array<Rgb, kSamples> SamplesOf(const float* linear,
                                               std::size_t lane) {
  std::array<Rgb, kSamples> samples;
  std::memcpy(static_cast<void*>(samples.data()), linear + lane * 3 * kSamples,
              sizeof(samples));
  return samples;
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace rtb
HWY_AFTER_NAMESPACE();

#endif  // RTB_ENCODERS_SIMD_SIDES_INL_H_
