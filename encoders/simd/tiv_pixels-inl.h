/// @file
/// Statistics of the 4 x 8 8-bit pixels of a cell in each lane, for encoder
/// `tiv`. For inclusion per target (Highway).

// Highway's guard, which flips with each target, in place of #pragma once.
#if defined(RTB_ENCODERS_SIMD_TIV_PIXELS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTB_ENCODERS_SIMD_TIV_PIXELS_INL_H_
#undef RTB_ENCODERS_SIMD_TIV_PIXELS_INL_H_
#else
#define RTB_ENCODERS_SIMD_TIV_PIXELS_INL_H_
#endif

#include <hwy/highway.h>

#include <utility>

#include "encoders/simd/cells-inl.h"
#include "encoders/simd/sorting_network.h"
#include "encoders/tiv_cell.h"

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR  // It has no vectors of bytes.

using ByteLanes = hn::Repartition<std::uint8_t, IntLanes>;

/// Pixels as 0xRRGGBB.
using Pixels = LaneArray<kTivPixels, std::int32_t>;

/// Turns 0xBBGGRR, with anything above, to 0xRRGGBB and back.
HWY_INLINE Ints RedFirst(Ints color) {
  const IntLanes di;
  const ByteLanes d8;
  alignas(16) static constexpr std::uint8_t kOrder[16] = {
      2, 1, 0, 0x80, 6, 5, 4, 0x80, 10, 9, 8, 0x80, 14, 13, 12, 0x80};
  return hn::BitCast(di, hn::TableLookupBytesOr0(hn::BitCast(d8, color),
                                                 hn::LoadDup128(d8, kOrder)));
}

/// A word of three pixels' bytes and the next: `kBits` of the first are left.
template <int kBits>
HWY_INLINE Ints Straddling(Ints first, Ints next) {
  const hn::RebindToUnsigned<IntLanes> du;
  const auto left = hn::ShiftRight<32 - kBits>(hn::BitCast(du, first));
  return hn::Or(hn::BitCast(IntLanes(), left), hn::ShiftLeft<kBits>(next));
}

/// Four pixels are three words, the first byte lowest.
HWY_INLINE void LoadPixels(const Rgb8* samples, Pixels& pixels) {
  constexpr std::size_t kWords = 3 * kTivPixels / 4;
  LaneArray<kWords, std::int32_t> words;
  // Only ever read by bytes.
  Transpose<kWords>(IntLanes(), reinterpret_cast<const std::int32_t*>(samples),
                    words);
  for (std::size_t i = 0; i < kTivPixels; i += 4) {
    const std::size_t word = i / 4 * 3;
    const Ints first = words[word];
    const Ints second = words[word + 1];
    const Ints third = words[word + 2];
    pixels.Set(i, RedFirst(first));
    pixels.Set(i + 1, RedFirst(Straddling<8>(first, second)));
    pixels.Set(i + 2, RedFirst(Straddling<16>(second, third)));
    pixels.Set(i + 3, RedFirst(hn::ShiftRight<8>(third)));
  }
}

HWY_INLINE ColorLanes ChannelsOf(Ints color) {
  const FloatLanes d;
  const Ints byte = hn::Set(IntLanes(), 255);
  return {hn::ConvertTo(d, hn::ShiftRight<16>(color)),
          hn::ConvertTo(d, hn::And(hn::ShiftRight<8>(color), byte)),
          hn::ConvertTo(d, hn::And(color, byte))};
}

HWY_INLINE Floats Dot(const ColorLanes& a, const ColorLanes& b) {
  return hn::MulAdd(a.r, b.r, hn::MulAdd(a.g, b.g, hn::Mul(a.b, b.b)));
}

/// The most frequent color and the second; the same where there is just one.
struct DominantColors {
  Ints first, second;
  hn::Mask<IntLanes> direct;  ///< Together they cover more than half.
};

/// Puts two of the values in order.
template <std::size_t kLow, std::size_t kHigh, std::size_t kCount>
HWY_INLINE void CompareExchange(LaneArray<kCount>& values) {
  const Floats a = values[kLow];
  const Floats b = values[kHigh];
  values.Set(kLow, hn::Min(a, b));
  values.Set(kHigh, hn::Max(a, b));
}

/// Straight-line code, which keeps most values in registers.
template <std::size_t kCount, std::size_t... kIndices>
HWY_INLINE void SortBy(LaneArray<kCount>& values,
                       std::index_sequence<kIndices...> /*all*/) {
  constexpr const auto& kNetwork = kSortingNetwork<kCount>;
  (CompareExchange<kNetwork.low[kIndices], kNetwork.high[kIndices]>(values),
   ...);
}

template <std::size_t kCount>
HWY_INLINE void Sort(LaneArray<kCount>& values) {
  SortBy(values, std::make_index_sequence<kSortingNetwork<kCount>.size>());
}

/// Sorts the colors and looks for the two longest runs; of equal ones the
/// larger color is the longer. Integers are compared as floats, which
/// are ordered alike where they are positive and normal: kNormal keeps them so.
HWY_INLINE DominantColors FindDominant(const Pixels& pixels) {
  constexpr int kColorBits = 24;
  constexpr std::int32_t kNormal = 0x3f << kColorBits;
  const FloatLanes d;
  const IntLanes di;
  LaneArray<kTivPixels> sorted;
  for (std::size_t i = 0; i < kTivPixels; ++i) {
    sorted.Set(i, hn::BitCast(d, hn::Or(pixels[i], hn::Set(di, kNormal))));
  }
  Sort(sorted);
  const Ints one = hn::Set(di, 1 << kColorBits);
  Floats first = hn::Zero(d);
  Floats second = hn::Zero(d);
  Ints run = one;
  for (std::size_t i = 0; i < kTivPixels; ++i) {
    Floats key = hn::BitCast(d, hn::Add(run, hn::BitCast(di, sorted[i])));
    if (i + 1 < kTivPixels) {
      const auto goes_on = hn::Eq(sorted[i], sorted[i + 1]);
      key = hn::IfThenZeroElse(goes_on, key);
      run = hn::Add(one, hn::IfThenElseZero(hn::RebindMask(di, goes_on), run));
    }
    second = hn::Max(second, hn::Min(first, key));
    first = hn::Max(first, key);
  }
  const Ints key1 = hn::BitCast(di, first);
  const Ints key2 = hn::BitCast(
      di, hn::IfThenElse(hn::Gt(second, hn::Zero(d)), second, first));
  const Ints color = hn::Set(di, (1 << kColorBits) - 1);
  const auto count = [&](Floats key) {
    return hn::Sub(hn::ShiftRight<kColorBits>(hn::BitCast(di, key)),
                   hn::Set(di, kNormal >> kColorBits));
  };
  // Of one color alone there are 32, and `second` is 0: still more than half.
  const auto direct =
      hn::Gt(hn::Add(count(first), hn::Max(count(second), hn::Zero(di))),
             hn::Set(di, kTivPixels / 2));
  return {hn::And(key1, color), hn::And(key2, color), direct};
}

/// In each lane, in the byte of the channel of the largest range (the first
/// of equal ones) the middle of it, 255 in the others.
HWY_INLINE Ints RangeSplit(const Pixels& pixels) {
  const IntLanes di;
  const ByteLanes d8;
  auto low = hn::BitCast(d8, pixels[0]);
  auto high = low;
  for (std::size_t i = 1; i < kTivPixels; ++i) {
    const auto pixel = hn::BitCast(d8, pixels[i]);
    low = hn::Min(low, pixel);
    high = hn::Max(high, pixel);
  }
  // No channel's difference borrows from the next.
  const Ints lows = hn::BitCast(di, low);
  const Ints ranges = hn::Sub(hn::BitCast(di, high), lows);
  const Ints byte = hn::Set(di, 255);
  const Ints red = hn::ShiftRight<16>(ranges);
  const Ints green = hn::And(hn::ShiftRight<8>(ranges), byte);
  const Ints blue = hn::And(ranges, byte);
  const auto is_green = hn::Gt(green, red);
  const auto is_blue = hn::Gt(blue, hn::Max(red, green));
  const Ints channel =
      hn::IfThenElse(is_blue, byte,
                     hn::IfThenElse(is_green, hn::ShiftLeft<8>(byte),
                                    hn::ShiftLeft<16>(byte)));
  const Ints half_ranges =
      hn::And(hn::ShiftRight<1>(ranges), hn::Set(di, 0x7f7f7f));
  const Ints split = hn::And(hn::Add(lows, half_ranges), channel);
  return hn::Or(split, hn::AndNot(channel, hn::Set(di, -1)));
}

/// Sums of channels, red and blue in one word.
struct SumPair {
  Ints red_blue, green;
};

HWY_INLINE SumPair PairOf(Ints pixel) {
  const IntLanes di;
  return {hn::And(pixel, hn::Set(di, 0xff00ff)),
          hn::And(hn::ShiftRight<8>(pixel), hn::Set(di, 255))};
}

HWY_INLINE SumPair SumAll(const Pixels& pixels) {
  SumPair sum = PairOf(pixels[0]);
  for (std::size_t i = 1; i < kTivPixels; ++i) {
    const SumPair pixel = PairOf(pixels[i]);
    sum.red_blue = hn::Add(sum.red_blue, pixel.red_blue);
    sum.green = hn::Add(sum.green, pixel.green);
  }
  return sum;
}

/// Packed means of `count` pixels, 0 for none. Exact: sums are at most 8160,
/// and half a unit more keeps a quotient 1/64 away from whole numbers.
HWY_INLINE Ints TruncatedMeans(const SumPair& sum, Floats count) {
  const FloatLanes d;
  const IntLanes di;
  const Floats one = hn::Set(d, 1);
  const Floats reciprocal = hn::Div(one, hn::Max(count, one));
  const auto mean = [&](Ints total) {
    const Floats moved = hn::Add(hn::ConvertTo(d, total), hn::Set(d, 0.5f));
    return hn::ConvertTo(di, hn::Mul(moved, reciprocal));
  };
  return PackCodes(mean(hn::ShiftRight<16>(sum.red_blue)), mean(sum.green),
                   mean(hn::And(sum.red_blue, hn::Set(di, 0xffff))));
}

#endif
// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace rtb
HWY_AFTER_NAMESPACE();

#endif  // RTB_ENCODERS_SIMD_TIV_PIXELS_INL_H_
