/// @file
/// What TerminalImageViewer 1.3 makes of one cell's pixels: the lines of
/// tiv_cell.h's function and of a GPU's kernel. Host and device.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <iterator>

#include "core/base/host_device.h"
#include "encoders/cell.h"
#include "encoders/tiv_cell.h"

namespace rtb {

/// Colors as 0xRRGGBB, which are ordered as Rgb8's are.
/// @{
RTB_HD inline std::uint32_t PackedColor(Rgb8 color) {
  return std::uint32_t{color.r} << 16 | std::uint32_t{color.g} << 8 | color.b;
}
RTB_HD inline Rgb8 UnpackedColor(std::uint32_t packed) {
  return {static_cast<std::uint8_t>(packed >> 16),
          static_cast<std::uint8_t>(packed >> 8 & 255),
          static_cast<std::uint8_t>(packed & 255)};
}
/// @param shift 16, 8 or 0: red, green or blue.
RTB_HD inline int ChannelOf(std::uint32_t packed, unsigned shift) {
  return static_cast<int>(packed >> shift & 255);
}
/// @}

/// A set of a cell's pixels as TivGlyph has it.
using TivBitmap = std::uint32_t;

/// The most frequent color and the second; the same where there is just one.
struct TivDominant {
  std::uint32_t first = 0, second = 0;
  bool direct = false;  ///< Together they cover more than half of the pixels.
};

/// Of equally frequent colors the larger comes first.
RTB_HD inline TivDominant FindTivDominant(const std::uint32_t* pixels) {
  constexpr unsigned kColorBits = 24;
  // How often a color is there, above the color; 0: there is none.
  std::uint32_t first = 0, second = 0;
  for (int i = 0; i < kTivPixels; ++i) {
    std::uint32_t times = 0;
    for (int j = 0; j < kTivPixels; ++j) times += pixels[j] == pixels[i];
    const std::uint32_t key = times << kColorBits | pixels[i];
    if (key > first) {
      second = first;
      first = key;
    } else if (key < first && key > second) {
      second = key;
    }
  }
  const std::uint32_t covered = (first >> kColorBits) + (second >> kColorBits);
  constexpr std::uint32_t kColor = (1u << kColorBits) - 1;
  return {first & kColor, (second > 0 ? second : first) & kColor,
          covered > kTivPixels / 2};
}

/// The pixels that `is_set` accepts.
template <class Predicate>
RTB_HD TivBitmap TivBitmapOf(const std::uint32_t* pixels,
                             const Predicate& is_set) {
  TivBitmap bitmap = 0;
  for (int i = 0; i < kTivPixels; ++i) {
    bitmap = bitmap << 1 | static_cast<TivBitmap>(is_set(pixels[i]));
  }
  return bitmap;
}

RTB_HD inline int SquaredDistance(std::uint32_t a, std::uint32_t b) {
  int sum = 0;
  for (unsigned shift = 0; shift < 24; shift += 8) {
    const int difference = ChannelOf(a, shift) - ChannelOf(b, shift);
    sum += difference * difference;
  }
  return sum;
}

/// The pixels nearer to the second color than to the first.
RTB_HD inline TivBitmap DirectTivBitmap(const std::uint32_t* pixels,
                                        const TivDominant& dominant) {
  return TivBitmapOf(pixels, [&](std::uint32_t pixel) {
    return SquaredDistance(pixel, dominant.first) >
           SquaredDistance(pixel, dominant.second);
  });
}

/// The channel of the largest range (the first of equal ones), split at its
/// middle.
RTB_HD inline TivBitmap RangeTivBitmap(const std::uint32_t* pixels) {
  unsigned widest = 0;
  int widest_range = -1;
  int split = 0;
  for (const unsigned shift : {16u, 8u, 0u}) {
    int low = 255;
    int high = 0;
    for (int i = 0; i < kTivPixels; ++i) {
      const int value = ChannelOf(pixels[i], shift);
      low = value < low ? value : low;
      high = value > high ? value : high;
    }
    if (high - low <= widest_range) continue;
    widest = shift;
    widest_range = high - low;
    split = low + widest_range / 2;
  }
  return TivBitmapOf(pixels, [&](std::uint32_t pixel) {
    return ChannelOf(pixel, widest) > split;
  });
}

/// The nearest glyph, and whether its complement is what came near.
struct TivMatch {
  TivGlyph glyph;
  bool complemented;
};

/// @param glyphs a copy of kTivGlyphs.
RTB_HD inline TivMatch FindTivGlyph(const TivGlyph* glyphs, TivBitmap bitmap) {
  TivMatch best{TivDefault(), false};
  int best_distance = kTivTooFar;
  for (std::size_t i = 0; i < std::size(kTivGlyphs); ++i) {
    const int distance = std::popcount(glyphs[i].pattern ^ bitmap);
    if (distance < best_distance) {
      best = {glyphs[i], false};
      best_distance = distance;
    }
    if (kTivPixels - distance < best_distance) {
      best = {glyphs[i], true};
      best_distance = kTivPixels - distance;
    }
  }
  return best;
}

/// Truncated mean of the pixels of a bitmap; black without any.
RTB_HD inline Rgb8 TivMean(const std::uint32_t* pixels, TivBitmap bitmap) {
  int sums[3] = {0, 0, 0};
  for (int i = 0; i < kTivPixels; ++i) {
    if ((bitmap >> (kTivPixels - 1 - i) & 1) == 0) continue;
    sums[0] += ChannelOf(pixels[i], 16);
    sums[1] += ChannelOf(pixels[i], 8);
    sums[2] += ChannelOf(pixels[i], 0);
  }
  const int count = std::popcount(bitmap);
  if (count == 0) return {};
  return {static_cast<std::uint8_t>(sums[0] / count),
          static_cast<std::uint8_t>(sums[1] / count),
          static_cast<std::uint8_t>(sums[2] / count)};
}

/// TivCell (tiv_cell.h) of packed colors.
/// @param glyphs a copy of kTivGlyphs.
RTB_HD inline Cell TivCellBy(const TivGlyph* glyphs,
                             const std::uint32_t* pixels) {
  const TivDominant dominant = FindTivDominant(pixels);
  const TivBitmap bitmap = dominant.direct ? DirectTivBitmap(pixels, dominant)
                                           : RangeTivBitmap(pixels);
  const TivMatch match = FindTivGlyph(glyphs, bitmap);
  const TivGlyph& glyph = match.glyph;
  if (!dominant.direct) {
    // Under the pattern itself, even where its complement won.
    return {glyph.code_point, TivMean(pixels, glyph.pattern),
            TivMean(pixels, ~glyph.pattern)};
  }
  const Rgb8 first = UnpackedColor(dominant.first);
  const Rgb8 second = UnpackedColor(dominant.second);
  return match.complemented ? Cell{glyph.code_point, first, second}
                            : Cell{glyph.code_point, second, first};
}

}  // namespace rtb
