#include "encoders/glyphs/glyph_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <thread>

#include "core/base/check.h"

namespace rtb {
namespace {

const Mask& MaskFrom(GlyphSet& glyphs, char32_t glyph) {
  const auto mask = glyphs.Get(glyph);
  if (!mask) CheckFailed(__FILE__, __LINE__, mask.error().ToString());
  return **mask;
}

double ColumnSum(const Mask& mask, int x) {
  double sum = 0;
  for (int y = 0; y < mask.height; ++y) sum += mask.at(x, y);
  return sum;
}

double RowSum(const Mask& mask, int y) {
  double sum = 0;
  for (int x = 0; x < mask.width; ++x) sum += mask.at(x, y);
  return sum;
}

double Sum(const Mask& mask) {
  return std::accumulate(mask.coverage.begin(), mask.coverage.end(), 0.0);
}

// Size 8 / 1233 px a unit. DejaVu Sans Mono's vertical line spans 536 .. 696
// units, so 3.478 .. 4.516 of 8 columns, and 1921 above to 512 below the
// baseline, which lies 12.6 from the top (see below): rows 0.136 .. 15.922.
TEST(FontMaskTest, VerticalLineFillsTheMiddle) {
  GlyphSet glyphs(8, 16, MaskSource::kGeometric);
  const Mask& mask = MaskFrom(glyphs, U'│');
  for (int y = 1; y < 15; ++y) {
    EXPECT_NEAR(mask.at(3, y), 0.522, 0.02) << y;
    EXPECT_NEAR(mask.at(4, y), 0.516, 0.02) << y;
  }
  EXPECT_NEAR(mask.at(3, 0), 0.522 * 0.864, 0.02);
  EXPECT_NEAR(mask.at(3, 15), 0.522 * 0.922, 0.02);
  EXPECT_NEAR(Sum(mask), 1.038 * 15.786, 0.3);
}

// Size 8 / 1233 px a unit: ascender 12.334, descender 3.134, rest 0.532: the
// baseline lies 3.4 above the bottom. The horizontal line spans 618 .. 790
// units, 4.01 .. 5.126 px above the baseline: 7.474 .. 8.59 from the top. It
// reaches 20 units beyond the cell on both sides, which is clipped.
TEST(FontMaskTest, HorizontalLineLiesWhereTheBaselinePutsIt) {
  GlyphSet glyphs(8, 16, MaskSource::kGeometric);
  const Mask& mask = MaskFrom(glyphs, U'─');
  EXPECT_NEAR(RowSum(mask, 7), 8 * 0.526, 0.2);
  EXPECT_NEAR(RowSum(mask, 8), 8 * 0.590, 0.2);
  EXPECT_NEAR(Sum(mask), 8 * 1.116, 0.2);
}

// The same in a higher cell: 8 rows more are shared evenly.
TEST(FontMaskTest, RestOfTheHeightIsSharedEvenly) {
  GlyphSet low(8, 16, MaskSource::kFont);
  GlyphSet high(8, 24, MaskSource::kFont);
  const Mask& a = MaskFrom(low, U'A');
  const Mask& b = MaskFrom(high, U'A');
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 8; ++x) EXPECT_EQ(a.at(x, y), b.at(x, y + 4));
  }
}

// Full block: 1921 - -512 units high, 15.79 px; the cell has 16 rows.
TEST(FontMaskTest, FontBlocksHaveGaps) {
  GlyphSet font(8, 16, MaskSource::kFont);
  const Mask& mask = MaskFrom(font, U'█');
  EXPECT_LT(Sum(mask), 127.9);
  EXPECT_GT(Sum(mask), 120);
  GlyphSet geometric(8, 16, MaskSource::kGeometric);
  EXPECT_EQ(Sum(MaskFrom(geometric, U'█')), 128);
  EXPECT_EQ(Sum(MaskFrom(font, U' ')), 0);
}

// DejaVu Sans Mono has no braille; DejaVu Sans has. Dots 1 and 8 lie in
// opposite corners.
TEST(FontMaskTest, FallsBackToDejaVuSans) {
  GlyphSet glyphs(8, 16, MaskSource::kGeometric);
  const Mask& first = MaskFrom(glyphs, U'⠁');
  EXPECT_GT(first.at(2, 4) + first.at(2, 3) + first.at(1, 3), 0.5);
  EXPECT_EQ(ColumnSum(first, 6), 0);
  const Mask& last = MaskFrom(glyphs, U'⢀');
  EXPECT_EQ(ColumnSum(last, 1), 0);
  EXPECT_GT(ColumnSum(last, 5), 0.5);
  EXPECT_EQ(Sum(MaskFrom(glyphs, 0x2800)), 0);
}

// Neither DejaVu has sextants: drawn as terminals draw them.
TEST(FontMaskTest, ShapesStandInForGlyphsThatNoFontHas) {
  GlyphSet font(8, 18, MaskSource::kFont);
  EXPECT_EQ(Sum(MaskFrom(font, 0x1FB00)), 4 * 6);
}

TEST(GlyphSetTest, GlyphsThatNothingDrawsAreErrors) {
  GlyphSet glyphs(8, 16, MaskSource::kGeometric);
  const auto mask = glyphs.Get(0x4E00);
  ASSERT_FALSE(mask);
  EXPECT_EQ(mask.error().kind, ErrorKind::kMissing);
  EXPECT_EQ(mask.error().place, "U+4E00");
}

TEST(GlyphSetTest, UnusableFontsAreErrorsWhenTheyAreNeeded) {
  GlyphSet missing(8, 16, MaskSource::kGeometric, "/nonexistent/font.ttf");
  EXPECT_TRUE(missing.Get(U'█'));
  const auto mask = missing.Get(U'A');
  ASSERT_FALSE(mask);
  EXPECT_EQ(mask.error().kind, ErrorKind::kBadInput);
  EXPECT_EQ(mask.error().place, "/nonexistent/font.ttf");
  GlyphSet text(8, 16, MaskSource::kFont,
                std::string(RTB_TEST_SOURCE_DIR) + "/CMakeLists.txt");
  ASSERT_FALSE(text.Get(U'A'));
  EXPECT_EQ(text.Get(U'A').error().kind, ErrorKind::kBadInput);
}

TEST(GlyphSetTest, GivenFontComesFirst) {
  GlyphSet sans(8, 16, MaskSource::kFont, FontChain("")[1]);
  GlyphSet mono(8, 16, MaskSource::kFont);
  EXPECT_NE(MaskFrom(sans, U'i').coverage, MaskFrom(mono, U'i').coverage);
}

TEST(GlyphSetTest, MasksAreKeptAndSharedBetweenThreads) {
  GlyphSet glyphs(8, 16, MaskSource::kFont);
  std::vector<std::vector<const Mask*>> seen(4);
  std::vector<std::thread> threads;
  for (auto& masks : seen) {
    threads.emplace_back([&glyphs, &masks] {
      for (char32_t glyph = U'!'; glyph <= U'~'; ++glyph) {
        masks.push_back(&MaskFrom(glyphs, glyph));
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const auto& masks : seen) EXPECT_EQ(masks, seen[0]);
}

}  // namespace
}  // namespace rtb
