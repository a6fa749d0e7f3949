#include "encoders/fit/fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/math/random.h"
#include "encoders/glyphs/glyph_lists.h"
#include "tests/encoders/fit/brute_force.h"
#include "tests/encoders/testing.h"

namespace rtb {
namespace {

constexpr Blend kSeparable[] = {Blend::kSrgb, Blend::kLinear};

Atlas AtlasOf(const std::string& names, int width, int height) {
  auto glyphs = GlyphsOf(names);
  EXPECT_TRUE(glyphs) << glyphs.error().ToString();
  auto atlas = MakeAtlas(*glyphs, width, height);
  EXPECT_TRUE(atlas) << atlas.error().ToString();
  return std::move(*atlas);
}

/// Coverages low + range * random.
FitMask RandomMask(int width, int height, double low, double range,
                   std::uint64_t seed) {
  Mask mask(width, height);
  for (std::size_t i = 0; i < mask.coverage.size(); ++i) {
    const auto bits = RandomBits(static_cast<std::uint32_t>(i), 1, 2, seed);
    mask.coverage[i] = static_cast<float>(low + range * UnitFloat(bits));
  }
  return MakeFitMask(U'x', mask);
}

/// The fit says what it costs, and no pair of codes costs less.
void ExpectBestPair(const FitMask& mask, Blend blend,
                    std::span<const V3d> samples) {
  const CellFit fit = RefitColors(mask, blend, samples);
  const double error = ErrorOf(mask, fit.cell, blend, samples);
  EXPECT_NEAR(fit.error, error, 1e-12);
  const double least = LeastErrorOfAllCodes(mask, blend, samples);
  EXPECT_LE(error, least + Tolerance(least, samples.size()));
}

// Where the mask is nearly constant, or covers next to nothing, many pairs of
// codes leave nearly the same error: neighbors of the rounded solution are not
// enough.
TEST(RefitColorsTest, NoPairOfCodesIsBetter) {
  struct Coverages {
    double low, range;
  };
  constexpr Coverages kCoverages[] = {{0, 1},       {0.5, 0.01},  {0.3, 0.1},
                                      {0, 0.02},    {0.97, 0.03}, {0.25, 0},
                                      {1.0 / 3, 0}, {0, 0},       {1, 0}};
  std::uint64_t seed = 0;
  for (const Coverages& coverages : kCoverages) {
    for (const SampleKind kind : kSampleKinds) {
      for (const Blend blend : kSeparable) {
        ++seed;
        SCOPED_TRACE(seed);
        const FitMask mask =
            RandomMask(2, 3, coverages.low, coverages.range, seed);
        ExpectBestPair(mask, blend, MakeSamples(kind, 6, seed));
      }
    }
  }
}

// Two sub-pixels of coverage 1/4 and 3/4 with samples 0 and 1 want f = 1.5 and
// b = -0.5. With f clamped to 1 the least of (1/4 + 3/4 b)^2 + (b/4 - 1/4)^2 is
// at b = -0.2, clamped to 0 too; 2/16 is left in each channel.
TEST(RefitColorsTest, ClampsBothColors) {
  Mask mask(1, 2);
  mask.coverage = {0.25f, 0.75f};
  const std::vector<V3d> samples = {V3d(0), V3d(1)};
  const CellFit fit =
      RefitColors(MakeFitMask(U'x', mask), Blend::kSrgb, samples);
  EXPECT_EQ(fit.cell, (Cell{U'x', {255, 255, 255}, {0, 0, 0}}));
  EXPECT_NEAR(fit.error, 3 * 0.125, 1e-12);
}

/// The fit's error is the least of all glyphs and codes, and no glyph of a
/// lower code point is as good.
void ExpectBestOfAll(const Atlas& atlas, Blend blend,
                     std::span<const V3d> samples) {
  const CellFit fit = FitCell(atlas, blend, samples);
  EXPECT_EQ(atlas.Find(fit.cell.glyph), fit.candidate);
  double least = std::numeric_limits<double>::infinity();
  std::vector<double> errors;
  for (const FitMask& mask : atlas.candidates()) {
    errors.push_back(LeastErrorOfAllCodes(mask, blend, samples));
    least = std::min(least, errors.back());
  }
  const double tolerance = Tolerance(least, samples.size());
  EXPECT_LE(fit.error, least + tolerance);
  const auto chosen = static_cast<std::size_t>(fit.candidate);
  for (std::size_t i = 0; i < chosen; ++i) {
    EXPECT_GT(errors[i], fit.error) << i << " instead of " << chosen;
  }
  const FitMask& mask = atlas.candidates()[chosen];
  EXPECT_NEAR(fit.error, ErrorOf(mask, fit.cell, blend, samples), 1e-12);
}

TEST(FitCellTest, NoGlyphInAnyColorsIsBetter) {
  // At these sizes eighths and sextants cover sub-pixels in part.
  const Atlas small = AtlasOf("blocks+quadrants+eighths", 2, 2);
  const Atlas odd = AtlasOf("blocks+quadrants", 3, 4);
  const Atlas mixed = AtlasOf("blocks+shades", 1, 3);
  std::uint64_t seed = 100;
  for (const SampleKind kind : kSampleKinds) {
    for (const Blend blend : kSeparable) {
      ++seed;
      SCOPED_TRACE(seed);
      ExpectBestOfAll(small, blend, MakeSamples(kind, 4, seed));
      ExpectBestOfAll(odd, blend, MakeSamples(kind, 12, seed));
      ExpectBestOfAll(mixed, blend, MakeSamples(kind, 3, seed));
    }
  }
}

// Every pair of colors within 2 codes of the chosen ones, and every glyph in
// the colors that were chosen for it: all cost more, in OKLab too.
TEST(FitCellTest, NoNeighborIsBetterInOklab) {
  const Atlas atlas = AtlasOf("blocks+quadrants+eighths", 2, 4);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto kind = kSampleKinds[seed % std::size(kSampleKinds)];
    std::vector<Rgb> linear;
    for (const V3d& value : MakeSamples(kind, 8, seed)) {
      linear.emplace_back(Rgb(value));
    }
    std::vector<V3d> samples(linear.size());
    ToBlend(Blend::kOklab, linear, samples);
    const CellFit fit = FitCell(atlas, Blend::kOklab, samples);
    for (const FitMask& mask : atlas.candidates()) {
      const CellFit other = RefitColors(mask, Blend::kOklab, samples);
      EXPECT_LE(fit.error, other.error + 1e-6);
      Cell cell = other.cell;
      for (int i = 0; i < 125; ++i) {
        const auto moved = [&](std::uint8_t code, int step) {
          return static_cast<std::uint8_t>(std::clamp(code + step, 0, 255));
        };
        cell.fg = {moved(other.cell.fg.r, i % 5 - 2),
                   moved(other.cell.fg.g, i / 5 % 5 - 2),
                   moved(other.cell.fg.b, i / 25 - 2)};
        EXPECT_GE(ErrorOf(mask, cell, Blend::kOklab, samples) + 1e-9,
                  other.error);
      }
    }
  }
}

// A pattern and its complement are equally good: the upper half (U+2580) wins
// against the lower one (U+2584), U+2596 against U+259C.
TEST(FitCellTest, TheLowerCodePointWinsATie) {
  const Atlas atlas = AtlasOf("blocks+quadrants+eighths", 2, 2);
  const std::vector<V3d> halves = {V3d(1), V3d(1), V3d(0), V3d(0)};
  const CellFit half = FitCell(atlas, Blend::kSrgb, halves);
  EXPECT_EQ(half.cell, (Cell{U'▀', {255, 255, 255}, {0, 0, 0}}));
  EXPECT_NEAR(half.error, 0, 1e-15);
  const std::vector<V3d> quarter = {V3d(1), V3d(1), V3d(0), V3d(1)};
  EXPECT_EQ(FitCell(atlas, Blend::kSrgb, quarter).cell,
            (Cell{U'▖', {0, 0, 0}, {255, 255, 255}}));
}

// 101/255 everywhere: a space, which has no foreground.
TEST(FitCellTest, OneColorIsASpace) {
  const Atlas atlas = AtlasOf("blocks+quadrants+eighths+shades", 4, 8);
  const std::vector<V3d> samples(32, V3d(101, 7, 255) / 255);
  EXPECT_EQ(FitCell(atlas, Blend::kSrgb, samples).cell,
            (Cell{U' ', {0, 0, 0}, {101, 7, 255}}));
}

// Only a shade shows a value between two codes, here 100.25/255 = (101 + 3 *
// 100) / 4 / 255.
TEST(FitCellTest, AShadeShowsQuartersOfACode) {
  const Atlas atlas = AtlasOf("shades", 2, 2);
  const std::vector<V3d> samples(4, V3d(100.25 / 255));
  const CellFit fit = FitCell(atlas, Blend::kSrgb, samples);
  EXPECT_EQ(fit.cell.glyph, U'░');
  EXPECT_NEAR(fit.error, 0, 1e-14);
}

// Unrounded colors cost no more than rounded ones and stay displayable.
TEST(FitCellUnroundedTest, BoundsTheRoundedFit) {
  const Atlas atlas = AtlasOf("blocks+quadrants+eighths", 3, 5);
  for (const SampleKind kind : kSampleKinds) {
    for (const Blend blend : kSeparable) {
      const auto samples = MakeSamples(kind, 15, 3);
      const CellFit rounded = FitCell(atlas, blend, samples);
      const UnroundedFit free = FitCellUnrounded(atlas, blend, samples);
      EXPECT_LE(free.error, rounded.error + 1e-12);
      for (const V3d& color : {free.fg, free.bg}) {
        for (int c = 0; c < 3; ++c) {
          EXPECT_GE(color[c], -1e-12);
          EXPECT_LE(color[c], 1 + 1e-12);
        }
      }
    }
  }
}

// Of one mask as of an atlas that has no other.
TEST(RefitUnroundedTest, BoundsEveryPairOfOneMask) {
  const Atlas atlas = AtlasOf("blocks+quadrants", 3, 5);
  for (const SampleKind kind : kSampleKinds) {
    const auto samples = MakeSamples(kind, 15, 4);
    double best = 1e9;
    for (const FitMask& mask : atlas.candidates()) {
      const double free = RefitUnrounded(mask, Blend::kSrgb, samples).error;
      EXPECT_LE(free, RefitColors(mask, Blend::kSrgb, samples).error + 1e-12);
      best = std::min(best, free);
    }
    EXPECT_NEAR(FitCellUnrounded(atlas, Blend::kSrgb, samples).error, best,
                1e-5);
  }
}

// With samples of 8-bit colors in two halves the free colors are these.
TEST(FitCellUnroundedTest, FindsTheColorsThemselves) {
  const Atlas atlas = AtlasOf("blocks", 1, 2);
  const std::vector<V3d> samples = {V3d(0.1234, 0.5, 1), V3d(0.9, 0, 0.3)};
  const UnroundedFit fit = FitCellUnrounded(atlas, Blend::kSrgb, samples);
  EXPECT_NEAR(fit.error, 0, 1e-14);
  EXPECT_TRUE(fit.fg.equalWithAbsError(samples[0], 1e-12));
  EXPECT_TRUE(fit.bg.equalWithAbsError(samples[1], 1e-12));
}

}  // namespace
}  // namespace rtb
