#include "encoders/fit/atlas.h"

#include <gtest/gtest.h>

#include "encoders/glyphs/glyph_lists.h"

namespace rtb {
namespace {

Atlas AtlasOf(std::vector<char32_t> glyphs, int width, int height) {
  auto atlas = MakeAtlas(glyphs, width, height);
  EXPECT_TRUE(atlas) << atlas.error().ToString();
  return std::move(*atlas);
}

// Coverages 0, 1, 1/2, 1/2: mean 1/2.
TEST(FitMaskTest, KnowsItsSums) {
  Mask mask(2, 2);
  mask.coverage = {0, 1, 0.5f, 0.5f};
  const FitMask made = MakeFitMask(U'x', mask);
  EXPECT_EQ(made.sum, 2);
  EXPECT_EQ(made.sum_squares, 1.5);
  EXPECT_EQ(made.variance, 0.5);
  EXPECT_FALSE(made.binary());
  EXPECT_FALSE(made.constant());
}

TEST(FitMaskTest, TellsConstantAndBinaryMasks) {
  Mask mask(3, 1);
  mask.coverage = {0.3f, 0.3f, 0.3000001f};
  EXPECT_TRUE(MakeFitMask(U'x', mask).constant());
  EXPECT_FALSE(MakeFitMask(U'x', mask).binary());
  mask.coverage = {1, 1, 1};
  EXPECT_TRUE(MakeFitMask(U'x', mask).constant());
  EXPECT_TRUE(MakeFitMask(U'x', mask).binary());
  mask.coverage = {1, 0, 0.9999999f};
  EXPECT_FALSE(MakeFitMask(U'x', mask).constant());
  EXPECT_TRUE(MakeFitMask(U'x', mask).binary());
}

// In 2 x 4 sub-pixels U+2584 (lower half) is the complement of U+2580, and
// U+2588 that of the space.
TEST(AtlasTest, FindsComplements) {
  const Atlas atlas = AtlasOf({U' ', 0x2580, 0x2584, 0x2588}, 2, 4);
  ASSERT_EQ(atlas.candidates().size(), 4u);
  EXPECT_EQ(atlas.candidates()[0].complement, -1);
  EXPECT_EQ(atlas.candidates()[1].complement, -1);
  EXPECT_EQ(atlas.candidates()[2].complement, 1);
  EXPECT_EQ(atlas.candidates()[3].complement, 0);
}

// The octant pattern of the lower quarter is U+2582 itself; a no-break space
// looks like a space.
TEST(AtlasTest, TheLowestCodePointStandsForEqualMasks) {
  const Atlas atlas = AtlasOf({U' ', 0x00A0, 0x2580, 0x1CD00}, 8, 16);
  EXPECT_EQ(atlas.candidates().size(), 3u);
  EXPECT_EQ(atlas.Find(0x00A0), 0);
  EXPECT_EQ(atlas.Find(U' '), 0);
  EXPECT_EQ(atlas.Find(0x2580), 1);
  EXPECT_EQ(atlas.Find(0x1CD00), 2);
  EXPECT_EQ(atlas.Find(U'A'), -1);
  // One sub-pixel tells no halves apart: both cover 1/2.
  const Atlas coarse = AtlasOf({0x2580, 0x258C}, 1, 1);
  EXPECT_EQ(coarse.candidates().size(), 1u);
  EXPECT_EQ(coarse.Find(0x258C), 0);
}

TEST(AtlasTest, EveryListHasMasks) {
  for (const std::string& name : GlyphListNames()) {
    const auto glyphs = GlyphsOf(name);
    const Atlas atlas = AtlasOf(*glyphs, 8, 16);
    for (const char32_t glyph : *glyphs) EXPECT_GE(atlas.Find(glyph), 0);
  }
}

TEST(AtlasTest, PassesOnWhatIsWrongWithAFont) {
  const std::vector<char32_t> glyphs = {U' ', U'A'};
  const auto atlas =
      MakeAtlas(glyphs, 8, 16, MaskSource::kFont, "no/such/font.ttf");
  ASSERT_FALSE(atlas);
  EXPECT_EQ(atlas.error().kind, ErrorKind::kBadInput);
}

}  // namespace
}  // namespace rtb
