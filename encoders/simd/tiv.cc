// Encoder `tiv` with vectors: one cell a lane.
#include <utility>

#include "core/base/check.h"
#include "encoders/simd/kernels.h"
#include "encoders/tiv_cell.h"

// This file is compiled once for each target.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "encoders/simd/tiv.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "encoders/simd/tiv_pixels-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR

/// The bit of a pixel in a bitmap.
HWY_INLINE Ints BitOf(std::size_t pixel) {
  const auto bit = std::uint32_t{1} << (kTivPixels - 1 - pixel);
  return hn::Set(IntLanes(), static_cast<std::int32_t>(bit));
}

/// The pixels nearer to the second color than to the first: those with
/// 2 p (c2 - c1) > |c2|^2 - |c1|^2. All numbers are whole and below 2^24.
HWY_INLINE Ints DirectBitmap(const Pixels& pixels, Ints first, Ints second) {
  const IntLanes di;
  const ColorLanes c1 = ChannelsOf(first);
  const ColorLanes c2 = ChannelsOf(second);
  const ColorLanes way = c2 - c1;
  const Floats border = hn::Sub(Dot(c2, c2), Dot(c1, c1));
  Ints bitmap = hn::Zero(di);
  for (std::size_t i = 0; i < kTivPixels; ++i) {
    const Floats along = Dot(ChannelsOf(pixels[i]), way);
    const auto set = hn::Gt(hn::Add(along, along), border);
    bitmap =
        hn::Or(bitmap, hn::IfThenElseZero(hn::RebindMask(di, set), BitOf(i)));
  }
  return bitmap;
}

/// The channel of the largest range, split at its middle.
HWY_INLINE Ints RangeBitmap(const Pixels& pixels) {
  const IntLanes di;
  const ByteLanes d8;
  const Ints limit = RangeSplit(pixels);
  Ints bitmap = hn::Zero(di);
  for (std::size_t i = 0; i < kTivPixels; ++i) {
    const auto above =
        hn::SaturatedSub(hn::BitCast(d8, pixels[i]), hn::BitCast(d8, limit));
    const auto set = hn::Ne(hn::BitCast(di, above), hn::Zero(di));
    bitmap = hn::Or(bitmap, hn::IfThenElseZero(set, BitOf(i)));
  }
  return bitmap;
}

/// The nearest glyph, and whether its complement is what came near.
struct Match {
  Ints index;  ///< In GlyphTable.
  hn::Mask<IntLanes> complemented;
};

/// kTivGlyphs and, as the last entry, kTivDefault.
struct GlyphTable {
  static constexpr int kBits = 6;
  static constexpr std::size_t kDefault = (1u << kBits) - 1;
  std::int32_t patterns[1 << kBits] = {};
  std::int32_t code_points[1 << kBits] = {};

  constexpr GlyphTable() {
    static_assert(std::size(kTivGlyphs) < kDefault);
    for (std::size_t i = 0; i < std::size(kTivGlyphs); ++i) {
      Set(i, kTivGlyphs[i]);
    }
    Set(kDefault, kTivDefault);
  }
  constexpr void Set(std::size_t i, const TivGlyph& glyph) {
    patterns[i] = static_cast<std::int32_t>(glyph.pattern);
    code_points[i] = static_cast<std::int32_t>(glyph.code_point);
  }
};
constexpr GlyphTable kTable;

/// Keys are distance, place in the table, complement: the least one wins.
HWY_INLINE Match FindGlyph(Ints bitmap) {
  constexpr int kShift = GlyphTable::kBits + 1;
  const IntLanes di;
  const hn::RebindToUnsigned<IntLanes> du;
  // The greatest key of a glyph that is near enough, at kTivDefault's place.
  Ints best = hn::Set(di, (kTivTooFar << kShift) - 2);
  for (std::size_t i = 0; i < std::size(kTivGlyphs); ++i) {
    const int place = 2 * static_cast<int>(i);
    const Ints difference = hn::Xor(bitmap, hn::Set(di, kTable.patterns[i]));
    const Ints distance = hn::ShiftLeft<kShift>(
        hn::BitCast(di, hn::PopulationCount(hn::BitCast(du, difference))));
    const Ints key = hn::Add(distance, hn::Set(di, place));
    const Ints complement_key =
        hn::Sub(hn::Set(di, (kTivPixels << kShift) + place + 1), distance);
    best = hn::Min(best, hn::Min(key, complement_key));
  }
  const Ints place = hn::And(best, hn::Set(di, (1 << kShift) - 1));
  return {hn::ShiftRight<1>(place), hn::TestBit(best, hn::Set(di, 1))};
}

/// Packed truncated means of the pixels in the pattern and of the others.
HWY_INLINE std::pair<Ints, Ints> MeansUnder(const Pixels& pixels,
                                            Ints pattern) {
  const FloatLanes d;
  const IntLanes di;
  const hn::RebindToUnsigned<IntLanes> du;
  const SumPair total = SumAll(pixels);
  SumPair set{hn::Zero(di), hn::Zero(di)};
  for (std::size_t i = 0; i < kTivPixels; ++i) {
    const auto in = hn::TestBit(pattern, BitOf(i));
    const SumPair pixel = PairOf(pixels[i]);
    set.red_blue =
        hn::Add(set.red_blue, hn::IfThenElseZero(in, pixel.red_blue));
    set.green = hn::Add(set.green, hn::IfThenElseZero(in, pixel.green));
  }
  const Floats count = hn::ConvertTo(
      d, hn::BitCast(di, hn::PopulationCount(hn::BitCast(du, pattern))));
  const SumPair clear{hn::Sub(total.red_blue, set.red_blue),
                      hn::Sub(total.green, set.green)};
  return {TruncatedMeans(set, count),
          TruncatedMeans(clear, hn::Sub(hn::Set(d, kTivPixels), count))};
}

/// Encodes as many cells as there are lanes.
HWY_INLINE void EncodeLanes(const Rgb8* samples, Cell* cells) {
  const IntLanes di;
  Pixels pixels;
  LoadPixels(samples, pixels);
  const DominantColors dominant = FindDominant(pixels);
  Ints bitmap = RangeBitmap(pixels);
  if (!hn::AllFalse(di, dominant.direct)) {
    bitmap = hn::IfThenElse(
        dominant.direct, DirectBitmap(pixels, dominant.first, dominant.second),
        bitmap);
  }
  const Match match = FindGlyph(bitmap);
  const Ints pattern = hn::GatherIndex(di, kTable.patterns, match.index);
  const auto [set, clear] = MeansUnder(pixels, pattern);
  const Ints first = RedFirst(dominant.first);
  const Ints second = RedFirst(dominant.second);
  const Ints direct_fg = hn::IfThenElse(match.complemented, first, second);
  const Ints direct_bg = hn::IfThenElse(match.complemented, second, first);
  StoreCells(hn::GatherIndex(di, kTable.code_points, match.index),
             hn::IfThenElse(dominant.direct, direct_fg, set),
             hn::IfThenElse(dominant.direct, direct_bg, clear), cells);
}

void EncodeTiv(const Rgb8* pixels, std::span<Cell> cells) {
  ForEachBatch<kTivPixels>(pixels, cells, [](const Rgb8* batch, Cell* encoded) {
    EncodeLanes(batch, encoded);
  });
}

#else  // A target of one lane has no vectors of bytes.

void EncodeTiv(const Rgb8* pixels, std::span<Cell> cells) {
  for (Cell& cell : cells) {
    cell = TivCell(std::span<const Rgb8, kTivPixels>(pixels, kTivPixels));
    pixels += kTivPixels;
  }
}

#endif
// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace rtb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtb {

HWY_EXPORT(EncodeTiv);

void EncodeTivCells(std::span<const Rgb8> pixels, std::span<Cell> cells) {
  RTB_CHECK_EQ(pixels.size(), kTivPixels * cells.size());
  HWY_DYNAMIC_DISPATCH(EncodeTiv)(pixels.data(), cells);
}

}  // namespace rtb
#endif  // HWY_ONCE
