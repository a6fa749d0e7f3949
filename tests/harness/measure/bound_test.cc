#include "harness/measure/bound.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "encoders/glyphs/glyph_lists.h"
#include "harness/measure/glyph_set_name.h"
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
