#include "harness/measure/bound.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/color/srgb.h"
#include "encoders/glyphs/glyph_lists.h"
#include "encoders/registry.h"
#include "harness/image_source.h"
#include "harness/measure/glyph_set_name.h"
#include "harness/metrics/mse.h"
#include "harness/rasters.h"
#include "tests/harness/temporary_folder.h"

namespace rtb {
namespace {

using testing::HasSubstr;
using testing::Optional;

/// One cell, its left half black and its right half white.
Image LeftAndRight() {
  Image image(8, 16);
  for (int y = 0; y < 16; ++y) {
    for (int x = 4; x < 8; ++x) image.at(x, y) = Rgb(1);
  }
  return image;
}

std::vector<char32_t> Glyphs(const char* names) {
  return GlyphsOf(names).value();
}

// Both halves of a half block lie half on black and half on white: its best
// colors are gray, wrong by 0.5 everywhere. Left and right half blocks are
// right everywhere.
TEST(GlyphBoundTest, IsWhatTheBestGlyphLeaves) {
  const std::vector<char32_t> half = {U'▄'};
  EXPECT_NEAR(GlyphBound(LeftAndRight(), {1, 1}, half, {}, "").value(), 0.25,
              1e-12);
  EXPECT_NEAR(
      GlyphBound(LeftAndRight(), {1, 1}, Glyphs("blocks"), {}, "").value(), 0,
      1e-12);
}

// The mean over a cell that can be drawn and one that cannot.
TEST(GlyphBoundTest, IsAMeanOverCells) {
  Image image(16, 16);
  for (int y = 0; y < 16; ++y) {
    for (int x = 4; x < 8; ++x) image.at(x, y) = Rgb(1);
  }
  EXPECT_NEAR(GlyphBound(image, {2, 1}, std::vector{U'▄'}, {}, "").value(),
              0.125, 1e-12);
}

/// Smooth color with an edge across it: 4 x 2 cells, multiples of 1/255.
Image Picture() {
  Image image(32, 32);
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 32; ++x) {
      const bool above = 3 * y < 2 * x;
      image.at(x, y) =
          EncodedValues(Rgb8{static_cast<std::uint8_t>(8 * x),
                             static_cast<std::uint8_t>(above ? 250 : 4 * y),
                             static_cast<std::uint8_t>(100 + 2 * x)});
    }
  }
  return image;
}

/// The picture as an encoder draws that takes its samples from it.
double MseOf(const std::string& spec) {
  const Image picture = Picture();
  const Image linear = LinearOf(picture);
  ImageSource source(linear, Fit::kStretch, 1);
  const Encoding encoding =
      MakeEncoder(spec).value()->Run(source, {4, 2}, 0.5, {}).value();
  const Image drawn = Decode(encoding.grid, {}).value();
  return MeanSquaredError(MetricInput(picture, drawn));
}

// `optimal` sees every pixel of the picture. What it loses is the bound of its
// glyphs, and rounding to 8 bits: on average at most 1/4 code^2, its half code
// at worst. No other encoder of fewer glyphs is better.
TEST(GlyphBoundTest, IsWhatOptimalReaches) {
  const double rounding = 0.25 / (255.0 * 255.0);
  double last = 1;
  for (const std::string names :
       {"blocks", "blocks+quadrants", "blocks+quadrants+eighths+shades"}) {
    const double bound =
        GlyphBound(Picture(), {4, 2}, GlyphsOf(names).value(), {}, "").value();
    const double reached = MseOf("optimal:glyphs=" + names);
    EXPECT_GE(reached, bound * (1 - 1e-5)) << names;
    EXPECT_LE(reached, bound + rounding) << names;
    EXPECT_GT(bound, rounding) << names;
    EXPECT_LE(bound, last) << names;
    last = bound;
    EXPECT_GT(MseOf("half"), bound);
  }
}

// On ray-traced pictures the half blocks, the quadrants and all of U+2580-259F
// reach 17.9 to 27.3, 18.2 to 27.4 and 19.1 to 28.7 dB at 80 x 30 cells; this
// one, of 60 x 20 cells, is of that kind.
TEST(GlyphBoundTest, OfARayTracedPictureIsOfTheKnownOrder) {
  const Image picture = ReadDisplayed(std::string(RTB_TEST_SOURCE_DIR) +
                                          "/tests/data/metrics/spheres.png",
                                      0)
                            .value();
  const auto psnr = [&](const std::vector<char32_t>& glyphs) {
    const double mse = GlyphBound(picture, {60, 20}, glyphs, {}, "").value();
    return -10 * std::log10(mse);
  };
  const double half = psnr({U'▄'});
  const double quadrants = psnr(Glyphs("blocks+quadrants"));
  const double all = psnr(Glyphs("blocks+quadrants+eighths+shades"));
  EXPECT_GT(half, 17.9);
  EXPECT_GT(quadrants, half);
  EXPECT_GT(all, quadrants);
  EXPECT_LT(all, 28.7);
}

TEST(GlyphBoundTest, IsKeptInTheCache) {
  const TemporaryFolder folder;
  const std::vector<char32_t> half = {U'▄'};
  const auto bound = [&](const std::vector<char32_t>& glyphs) {
    return GlyphBound(LeftAndRight(), {1, 1}, glyphs, {}, folder.path())
        .value();
  };
  const double first = bound(half);
  EXPECT_EQ(bound(half), first);
  std::filesystem::path file;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    EXPECT_TRUE(file.empty());
    file = entry.path();
  }
  folder.Write(file.filename().string(), "0.75");
  EXPECT_EQ(bound(half), 0.75);
  EXPECT_NEAR(bound(Glyphs("blocks")), 0, 1e-12);
  folder.Write(file.filename().string(), "0.7x");  // damaged
  EXPECT_EQ(bound(half), first);
}

TEST(CompareWithBoundTest, GivesTheGap) {
  const BoundResult result = CompareWithBound("a", 0.5, "half", 0.25).value();
  EXPECT_EQ(result.glyphs, "half");
  EXPECT_EQ(result.mse, 0.25);
  EXPECT_THAT(result.gap, Optional(2.0));
  EXPECT_EQ(CompareWithBound("a", 0, "half", 0)->gap, std::nullopt);
}

TEST(CompareWithBoundTest, BelowTheBoundSomethingIsWrong) {
  const auto result = CompareWithBound("quadrant", 0.2, "half", 0.25);
  ASSERT_FALSE(result.has_value());
  EXPECT_EQ(result.error().kind, ErrorKind::kFailure);
  EXPECT_EQ(result.error().place, "quadrant");
  EXPECT_THAT(result.error().what, HasSubstr("measurement is wrong"));
  // Rounding alone is no error.
  EXPECT_TRUE(CompareWithBound("quadrant", 0.25 * (1 - 1e-6), "half", 0.25)
                  .has_value());
}

TEST(GlyphSetNameTest, KnowsTheLists) {
  EXPECT_EQ(GlyphSetName(std::vector{U'▄'}), "half");
  EXPECT_EQ(GlyphSetName(std::vector{U' ', U'▀', U'▄', U'█'}), "half");
  EXPECT_EQ(GlyphSetName(Glyphs("quadrants+blocks")), "blocks+quadrants");
  EXPECT_EQ(GlyphSetName(Glyphs("sextants")), "sextants");
  EXPECT_EQ(GlyphSetName(std::vector{U' ', U'▄', U'◢'}), "3 glyphs");
}

}  // namespace
}  // namespace rtb
