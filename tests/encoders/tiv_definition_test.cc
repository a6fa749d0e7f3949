// Encoder `tiv` against its definition, written out once more in the plainest
// way, on pixels that no picture of tests/data has.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <map>
#include <vector>

#include "core/math/random.h"
#include "encoders/simd/kernels.h"
#include "encoders/tiv_cell.h"
#include "tests/encoders/testing.h"
#include "tests/simd_targets.h"

namespace rtb {
namespace {

using Pixels = std::vector<std::array<int, 3>>;

int Distance(const std::array<int, 3>& a, const std::array<int, 3>& b) {
  int sum = 0;
  for (std::size_t c = 0; c < 3; ++c) sum += (a[c] - b[c]) * (a[c] - b[c]);
  return sum;
}

/// Colors with their counts, the most frequent first, of equal counts the
/// larger 0xRRGGBB.
std::vector<std::pair<int, std::array<int, 3>>> Ranked(const Pixels& pixels) {
  std::map<std::array<int, 3>, int> counts;
  for (const auto& pixel : pixels) ++counts[pixel];
  std::vector<std::pair<int, std::array<int, 3>>> ranked;
  for (const auto& [color, count] : counts) ranked.push_back({count, color});
  std::ranges::sort(ranked, std::greater<>());
  return ranked;
}

std::vector<bool> RangeBits(const Pixels& pixels) {
  std::size_t widest = 0;
  int range = -1;
  int split = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    int low = 255;
    int high = 0;
    for (const auto& pixel : pixels) {
      low = std::min(low, pixel[c]);
      high = std::max(high, pixel[c]);
    }
    if (high - low > range) {
      widest = c;
      range = high - low;
      split = low + range / 2;
    }
  }
  std::vector<bool> bits;
  for (const auto& pixel : pixels) bits.push_back(pixel[widest] > split);
  return bits;
}

bool PatternBit(std::uint32_t pattern, std::size_t i) {
  return (pattern & (0x80000000u >> i)) != 0;
}

Rgb8 Mean(const Pixels& pixels, std::uint32_t pattern, bool set) {
  std::array<int, 3> sum{};
  int count = 0;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (PatternBit(pattern, i) != set) continue;
    ++count;
    for (std::size_t c = 0; c < 3; ++c) sum[c] += pixels[i][c];
  }
  if (count == 0) return {};
  return {static_cast<std::uint8_t>(sum[0] / count),
          static_cast<std::uint8_t>(sum[1] / count),
          static_cast<std::uint8_t>(sum[2] / count)};
}

Rgb8 ToRgb8Of(const std::array<int, 3>& color) {
  return {static_cast<std::uint8_t>(color[0]),
          static_cast<std::uint8_t>(color[1]),
          static_cast<std::uint8_t>(color[2])};
}

Cell ByDefinition(const Pixels& pixels) {
  const auto ranked = Ranked(pixels);
  const auto& first = ranked[0];
  const auto second =
      ranked.size() > 1 ? ranked[1] : std::pair(0, first.second);
  const bool direct = first.first + second.first > 16;
  std::vector<bool> bits = RangeBits(pixels);
  if (direct) {
    for (std::size_t i = 0; i < 32; ++i) {
      bits[i] = Distance(pixels[i], first.second) >
                Distance(pixels[i], second.second);
    }
  }
  TivGlyph best{0x0000ffff, 0x2584};
  bool complemented = false;
  int least = 8;
  for (const TivGlyph& glyph : kTivGlyphs) {
    for (const bool complement : {false, true}) {
      int distance = 0;
      for (std::size_t i = 0; i < 32; ++i) {
        distance += (PatternBit(glyph.pattern, i) != complement) != bits[i];
      }
      if (distance < least) {
        best = glyph;
        complemented = complement;
        least = distance;
      }
    }
  }
  if (!direct) {
    return {best.code_point, Mean(pixels, best.pattern, true),
            Mean(pixels, best.pattern, false)};
  }
  Cell cell{best.code_point, ToRgb8Of(second.second), ToRgb8Of(first.second)};
  if (complemented) std::swap(cell.fg, cell.bg);
  return cell;
}

/// Pixels of `levels` levels a channel, `step` apart, of which some copy a
/// neighbor: from noise to two colors.
Pixels Random(std::uint32_t cell) {
  const std::uint32_t levels = 1 + cell % 7 * (cell % 3) * 6;
  const std::uint32_t step = 1 + cell % 5;
  const std::uint32_t copied = cell % 11;
  Pixels pixels;
  for (std::uint32_t i = 0; i < 32; ++i) {
    std::array<int, 3> color{};
    for (std::uint32_t c = 0; c < 3; ++c) {
      color[c] = static_cast<int>(
          (cell + RandomBits(cell, i, c, 4) % levels * step) % 256);
    }
    const bool copy = i > 0 && RandomBits(cell, i, 3, 4) % 11 < copied;
    pixels.push_back(copy ? pixels[RandomBits(cell, i, 5, 4) % i] : color);
  }
  return pixels;
}

TEST(TivDefinitionTest, EveryCellIsWhatTheDefinitionSays) {
  constexpr std::uint32_t kCells = 20'000;
  std::vector<Rgb8> pixels;
  std::vector<Cell> expected;
  for (std::uint32_t cell = 0; cell < kCells; ++cell) {
    const Pixels random = Random(cell);
    for (const auto& color : random) pixels.push_back(ToRgb8Of(color));
    expected.push_back(ByDefinition(random));
    ASSERT_EQ(TivCell(std::span<const Rgb8, 32>(
                  std::span(pixels).subspan(cell * 32u, 32))),
              expected.back())
        << cell;
  }
  ForEachSimdTarget([&] {
    std::vector<Cell> cells(kCells);
    EncodeTivCells(pixels, cells);
    for (std::size_t i = 0; i < kCells; ++i) {
      ASSERT_EQ(cells[i], expected[i]) << i;
    }
  });
}

}  // namespace
}  // namespace rtb
