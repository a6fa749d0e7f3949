#include "encoders/fit/palette_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "encoders/glyphs/glyph_lists.h"
#include "encoders/palette.h"
#include "tests/encoders/fit/brute_force.h"
#include "tests/encoders/testing.h"

namespace rtb {
namespace {

constexpr Blend kBlends[] = {Blend::kSrgb, Blend::kLinear, Blend::kOklab};

Atlas AtlasOf(const std::string& names, int width, int height) {
  auto atlas = MakeAtlas(*GlyphsOf(names), width, height);
  EXPECT_TRUE(atlas) << atlas.error().ToString();
  return std::move(*atlas);
}

std::vector<Rgb8> Xterm(int count) {
  std::vector<Rgb8> colors;
  for (int i = 0; i < count; ++i) colors.push_back(XtermColor(i));
  return colors;
}

/// The least error of all glyphs in all pairs of colors.
double LeastOfAll(const Atlas& atlas, Blend blend, std::span<const Rgb8> colors,
                  std::span<const V3d> samples) {
  double least = std::numeric_limits<double>::infinity();
  for (const FitMask& mask : atlas.candidates()) {
    for (const Rgb8& fg : colors) {
      for (const Rgb8& bg : colors) {
        const Cell cell = {mask.glyph, fg, bg};
        least = std::min(least, ErrorOf(mask, cell, blend, samples));
      }
    }
  }
  return least;
}

void ExpectBest(const Atlas& atlas, const FitPalette& palette,
                std::span<const V3d> samples) {
  const CellFit fit = FitCellToPalette(atlas, palette, samples);
  const auto& mask =
      atlas.candidates()[static_cast<std::size_t>(fit.candidate)];
  EXPECT_EQ(mask.glyph, fit.cell.glyph);
  EXPECT_NEAR(fit.error, ErrorOf(mask, fit.cell, palette.blend(), samples),
              1e-12);
  const double least =
      LeastOfAll(atlas, palette.blend(), palette.colors(), samples);
  EXPECT_LE(fit.error, least + Tolerance(least, samples.size()));
  for (const Rgb8& color : {fit.cell.fg, fit.cell.bg}) {
    EXPECT_NE(std::ranges::find(palette.colors(), color),
              palette.colors().end());
  }
}

// At 2 x 2 sub-pixels eighths cover some in part, and U+2584 and U+2585 differ
// by little; the shades make mixtures of any two colors.
TEST(PaletteFitTest, NoGlyphInAnyTwoColorsIsBetter) {
  const Atlas atlas = AtlasOf("blocks+eighths+shades", 2, 2);
  for (const Blend blend : kBlends) {
    const FitPalette palette(blend, Xterm(16));
    for (std::uint64_t seed = 0; seed < 25; ++seed) {
      SCOPED_TRACE(seed);
      const auto kind = kSampleKinds[seed % std::size(kSampleKinds)];
      ExpectBest(atlas, palette, MakeSamples(kind, 4, seed));
    }
  }
}

TEST(PaletteFitTest, TakesAnyNumberOfColors) {
  const Atlas atlas = AtlasOf("blocks", 2, 2);
  const auto samples = MakeSamples(SampleKind::kRandom, 4, 5);
  for (const int count : {1, 2, 40}) {
    ExpectBest(atlas, FitPalette(Blend::kSrgb, Xterm(count)), samples);
  }
}

TEST(PaletteFitTest, RefitsAGivenMask) {
  const Atlas atlas = AtlasOf("quadrants", 2, 2);
  const FitPalette palette(Blend::kSrgb, Xterm(16));
  // White on the diagonal, blue beside it.
  const V3d white(1, 1, 1);
  const V3d blue(0, 0, 0.9);
  const std::vector<V3d> samples = {white, blue, blue, white};
  const auto& mask =
      atlas.candidates()[static_cast<std::size_t>(atlas.Find(U'▚'))];
  EXPECT_EQ(RefitToPalette(mask, palette, samples).cell,
            (Cell{U'▚', {255, 255, 255}, {0, 0, 238}}));
}

// With the colors fixed, complements differ: white in the upper half of black
// is U+2580, and U+2584 with the samples upside down.
TEST(FixedColorsTest, ChooseTheGlyphAlone) {
  const Atlas atlas = AtlasOf("blocks", 1, 2);
  const std::vector<V3d> upper = {V3d(0.8), V3d(0.3)};
  const std::vector<V3d> lower = {V3d(0.3), V3d(0.8)};
  const Rgb8 white{255, 255, 255};
  const CellFit fit = FitCellToColors(atlas, Blend::kSrgb, upper, white, {});
  EXPECT_EQ(fit.cell, (Cell{U'▀', white, {0, 0, 0}}));
  EXPECT_NEAR(fit.error, 3 * (0.2 * 0.2 + 0.3 * 0.3), 1e-12);
  EXPECT_EQ(FitCellToColors(atlas, Blend::kSrgb, lower, white, {}).cell.glyph,
            U'▄');
}

// Of all glyphs none comes nearer to random samples in black and white.
TEST(FixedColorsTest, NoGlyphIsBetter) {
  const Atlas atlas = AtlasOf("quadrants+blocks+eighths+shades", 4, 4);
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const auto samples = MakeSamples(SampleKind::kGray, 16, seed);
    const Rgb8 fg{250, 240, 200};
    const Rgb8 bg{10, 20, 30};
    const CellFit fit = FitCellToColors(atlas, Blend::kSrgb, samples, fg, bg);
    for (const FitMask& mask : atlas.candidates()) {
      EXPECT_LE(
          fit.error,
          ErrorOf(mask, {mask.glyph, fg, bg}, Blend::kSrgb, samples) + 1e-5);
    }
  }
}

}  // namespace
}  // namespace rtb
