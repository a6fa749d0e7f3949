/// @file
/// What vector kernels share whose lanes are cells: reading samples, rounding
/// means, writing cells. For inclusion per target (Highway).

// Highway's guard, which flips with each target, in place of #pragma once.
#if defined(RTB_ENCODERS_SIMD_CELLS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTB_ENCODERS_SIMD_CELLS_INL_H_
#undef RTB_ENCODERS_SIMD_CELLS_INL_H_
#else
#define RTB_ENCODERS_SIMD_CELLS_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "core/color/srgb-inl.h"
#include "encoders/blend.h"
#include "encoders/cell.h"
#include "encoders/simd/transpose-inl.h"
#include "encoders/steps.h"

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A color in each lane.
struct ColorLanes {
  Floats r, g, b;
};

HWY_INLINE ColorLanes operator+(const ColorLanes& a, const ColorLanes& b) {
  return {hn::Add(a.r, b.r), hn::Add(a.g, b.g), hn::Add(a.b, b.b)};
}
HWY_INLINE ColorLanes operator-(const ColorLanes& a, const ColorLanes& b) {
  return {hn::Sub(a.r, b.r), hn::Sub(a.g, b.g), hn::Sub(a.b, b.b)};
}
HWY_INLINE ColorLanes operator*(const ColorLanes& a, Floats b) {
  return {hn::Mul(a.r, b), hn::Mul(a.g, b), hn::Mul(a.b, b)};
}
HWY_INLINE ColorLanes Select(FloatMask mask, const ColorLanes& yes,
                             const ColorLanes& no) {
  return {hn::IfThenElse(mask, yes.r, no.r), hn::IfThenElse(mask, yes.g, no.g),
          hn::IfThenElse(mask, yes.b, no.b)};
}

/// Colors in memory.
template <std::size_t kCount>
struct ColorArray {
  LaneArray<3 * kCount> values;

  ColorLanes operator[](std::size_t i) const {
    return {values[3 * i], values[3 * i + 1], values[3 * i + 2]};
  }
  void Set(std::size_t i, const ColorLanes& color) {
    values.Set(3 * i, color.r);
    values.Set(3 * i + 1, color.g);
    values.Set(3 * i + 2, color.b);
  }
};

/// Steps (steps.h) of kSamples linear samples a cell, of the cells from
/// `linear` on.
template <std::size_t kSamples>
HWY_INLINE void LoadSteps(const float* linear, ColorArray<kSamples>& steps) {
  constexpr std::size_t kValues = 3 * kSamples;
  const FloatLanes d;
  const SrgbCurveTable& table = SrgbCurve();
  const Floats white = hn::Set(d, static_cast<float>(kWhiteSteps));
  Transpose<kValues>(d, linear, steps.values);
  for (std::size_t i = 0; i < kValues; ++i) {
    const Floats encoded = SrgbCurveOf(d, steps.values[i], table);
    steps.values.Set(i, hn::Round(hn::Mul(encoded, white)));
  }
}

/// HSP brightness of a color (core/color/hsp.h), in the color's unit.
HWY_INLINE Floats BrightnessOf(const ColorLanes& color) {
  const FloatLanes d;
  const auto weighted = [d](float weight, Floats v) {
    return hn::Mul(hn::Set(d, weight), hn::Mul(v, v));
  };
  return hn::Sqrt(
      hn::Add(hn::Add(weighted(0.299f, color.r), weighted(0.587f, color.g)),
              weighted(0.114f, color.b)));
}

/// Codes of the means of `count` (0 to 8) samples whose steps sum to `sum`, as
/// ToRgb8 (blend.h) rounds them; 0 for no samples. Exact: whole numbers
/// below 2^25, and a quotient below 2^11 whose fraction is at least 1/16 away
/// from a whole number.
HWY_INLINE Ints CodesOfMeans(Floats sum, Floats count, Floats reciprocal) {
  const FloatLanes d;
  const IntLanes di;
  constexpr auto kNoiseSteps = static_cast<float>(kNoise * kWhiteSteps);
  const Floats half_up =
      hn::Add(hn::Mul(count, hn::Set(d, kStepsPerCode / 2.0f)),
              hn::Floor(hn::Mul(count, hn::Set(d, kNoiseSteps))));
  const Ints total =
      hn::Add(hn::ConvertTo(di, sum), hn::ConvertTo(di, half_up));
  constexpr int kShift = std::countr_zero(unsigned{kStepsPerCode});
  const Floats codes = hn::ConvertTo(d, hn::ShiftRight<kShift>(total));
  return hn::ConvertTo(di,
                       hn::Mul(hn::Add(codes, hn::Set(d, 0.5f)), reciprocal));
}

/// The codes of a color in each lane: red, then green, then blue from the
/// lowest byte on.
HWY_INLINE Ints PackCodes(Ints r, Ints g, Ints b) {
  return hn::Or(hn::Or(r, hn::ShiftLeft<8>(g)), hn::ShiftLeft<16>(b));
}

HWY_INLINE Ints CodesOfMeans(const ColorLanes& sum, Floats count) {
  const Floats one = hn::Set(FloatLanes(), 1);
  const Floats reciprocal = hn::Div(one, hn::Max(count, one));
  return PackCodes(CodesOfMeans(sum.r, count, reciprocal),
                   CodesOfMeans(sum.g, count, reciprocal),
                   CodesOfMeans(sum.b, count, reciprocal));
}

// A cell is three 32-bit words: the glyph; foreground and the background's
// red; the background's green and blue.
static_assert(sizeof(Cell) == 12 && std::endian::native == std::endian::little);
static_assert(offsetof(Cell, fg) == 4 && offsetof(Cell, bg) == 7);

/// Writes one cell a lane, of packed codes.
HWY_INLINE void StoreCells(Ints glyph, Ints fg, Ints bg, Cell* cells) {
  const hn::RebindToUnsigned<IntLanes> du;
  const Ints colors = hn::Or(fg, hn::ShiftLeft<24>(bg));
  const Ints rest = hn::ShiftRight<8>(bg);
  HWY_ALIGN std::uint32_t words[3 * kMaxLanes];
  hn::StoreInterleaved3(hn::BitCast(du, glyph), hn::BitCast(du, colors),
                        hn::BitCast(du, rest), du, words);
  std::memcpy(static_cast<void*>(cells), words, hn::Lanes(du) * sizeof(Cell));
}

/// Calls `repair(lane)` for each lane of the mask.
template <class Repair>
HWY_INLINE void ForEachLane(FloatMask mask, const Repair& repair) {
  const FloatLanes d;
  if (HWY_LIKELY(hn::AllFalse(d, mask))) return;
  const IntLanes di;
  HWY_ALIGN std::int32_t lanes[kMaxLanes];
  hn::Store(hn::BitCast(di, hn::VecFromMask(d, mask)), di, lanes);
  for (std::size_t i = 0; i < hn::Lanes(d); ++i) {
    if (lanes[i] != 0) repair(i);
  }
}

/// Calls encode(samples, cells) for as many cells as there are lanes at a time;
/// the last ones go through a copy, filled up with zeros.
template <std::size_t kValuesPerCell, class T, class EncodeLanes>
HWY_INLINE void ForEachBatch(const T* samples, std::span<Cell> cells,
                             const EncodeLanes& encode) {
  const std::size_t lanes = hn::Lanes(FloatLanes());
  std::size_t i = 0;
  for (; i + lanes <= cells.size(); i += lanes) {
    encode(samples + i * kValuesPerCell, &cells[i]);
  }
  const std::size_t rest = cells.size() - i;
  if (rest == 0) return;
  std::array<T, kValuesPerCell * kMaxLanes> last{};
  std::array<Cell, kMaxLanes> encoded;
  std::copy_n(samples + i * kValuesPerCell, rest * kValuesPerCell,
              last.begin());
  encode(last.data(), encoded.data());
  std::copy_n(encoded.begin(), rest, cells.begin() + static_cast<long>(i));
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace rtb
HWY_AFTER_NAMESPACE();

#endif  // RTB_ENCODERS_SIMD_CELLS_INL_H_
