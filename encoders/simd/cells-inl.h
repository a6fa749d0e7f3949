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
#include "encoders/steps.h"

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using FloatLanes = hn::ScalableTag<float>;
using IntLanes = hn::RebindToSigned<FloatLanes>;
using Floats = hn::Vec<FloatLanes>;
using Ints = hn::Vec<IntLanes>;
using FloatMask = hn::Mask<FloatLanes>;

/// Room for one value in each lane.
constexpr std::size_t kMaxLanes = hn::MaxLanes(FloatLanes());

/// kCount vectors in memory, one after the other.
template <std::size_t kCount>
struct LaneArray {
  HWY_ALIGN_MAX float values[kCount * kMaxLanes];

  Floats operator[](std::size_t i) const {
    return hn::Load(FloatLanes(), values + i * kMaxLanes);
  }
  void Set(std::size_t i, Floats v) {
    hn::Store(v, FloatLanes(), values + i * kMaxLanes);
  }
};

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
  const FloatLanes d;
  const IntLanes di;
  const SrgbCurveTable& table = SrgbCurve();
  const Floats white = hn::Set(d, static_cast<float>(kWhiteSteps));
  const Ints cell =
      hn::Mul(hn::Iota(di, 0), hn::Set(di, static_cast<int>(3 * kSamples)));
  for (std::size_t i = 0; i < 3 * kSamples; ++i) {
    const Floats value = hn::GatherIndex(d, linear + i, cell);
    steps.values.Set(i,
                     hn::Round(hn::Mul(SrgbCurveOf(d, value, table), white)));
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

/// Three codes in each lane.
struct CodeLanes {
  Ints r, g, b;
};

HWY_INLINE CodeLanes CodesOfMeans(const ColorLanes& sum, Floats count) {
  const FloatLanes d;
  const Floats one = hn::Set(d, 1);
  const Floats reciprocal = hn::Div(one, hn::Max(count, one));
  return {CodesOfMeans(sum.r, count, reciprocal),
          CodesOfMeans(sum.g, count, reciprocal),
          CodesOfMeans(sum.b, count, reciprocal)};
}

// A cell is three 32-bit words: the glyph; foreground and the background's
// red; the background's green and blue.
static_assert(sizeof(Cell) == 12 && std::endian::native == std::endian::little);
static_assert(offsetof(Cell, fg) == 4 && offsetof(Cell, bg) == 7);

/// Writes one cell a lane.
HWY_INLINE void StoreCells(Ints glyph, const CodeLanes& fg, const CodeLanes& bg,
                           Cell* cells) {
  const hn::RebindToUnsigned<IntLanes> du;
  const Ints colors =
      hn::Or(hn::Or(fg.r, hn::ShiftLeft<8>(fg.g)),
             hn::Or(hn::ShiftLeft<16>(fg.b), hn::ShiftLeft<24>(bg.r)));
  const Ints rest = hn::Or(bg.g, hn::ShiftLeft<8>(bg.b));
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
