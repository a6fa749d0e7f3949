#include "encoders/glyphs/patterns.h"

#include <gtest/gtest.h>

#include <set>

namespace rtb {
namespace {

// Bits of the names: SEXTANT-35 is 4 + 16 = 20, -235 is 22: 21, the left half,
// is left out. -146 is 41, -1246 is 43: 42, the right half, is left out.
TEST(SextantTest, FollowsTheUnicodeNames) {
  EXPECT_EQ(SextantGlyph(1), 0x1FB00u);   // -1
  EXPECT_EQ(SextantGlyph(3), 0x1FB02u);   // -12
  EXPECT_EQ(SextantGlyph(20), 0x1FB13u);  // -35
  EXPECT_EQ(SextantGlyph(22), 0x1FB14u);  // -235
  EXPECT_EQ(SextantGlyph(41), 0x1FB27u);  // -146
  EXPECT_EQ(SextantGlyph(43), 0x1FB28u);  // -1246
  EXPECT_EQ(SextantGlyph(62), 0x1FB3Bu);  // -23456
  EXPECT_EQ(SextantGlyph(0), U' ');
  EXPECT_EQ(SextantGlyph(21), U'▌');
  EXPECT_EQ(SextantGlyph(42), U'▐');
  EXPECT_EQ(SextantGlyph(63), U'█');
}

// The first names are OCTANT-3, -23, -123, -4, -14: 1, 2 and 3 stand
// elsewhere, and 5 is a quadrant. The last one is -2345678.
TEST(OctantTest, FollowsTheUnicodeNames) {
  EXPECT_EQ(OctantGlyph(4), 0x1CD00u);
  EXPECT_EQ(OctantGlyph(6), 0x1CD01u);
  EXPECT_EQ(OctantGlyph(7), 0x1CD02u);
  EXPECT_EQ(OctantGlyph(8), 0x1CD03u);
  EXPECT_EQ(OctantGlyph(9), 0x1CD04u);
  EXPECT_EQ(OctantGlyph(0xFE), 0x1CDE5u);
  EXPECT_EQ(OctantGlyph(0x01), 0x1CEA8u);  // LEFT HALF UPPER ONE QUARTER
  EXPECT_EQ(OctantGlyph(0x80), 0x1CEA0u);  // RIGHT HALF LOWER ONE QUARTER
  EXPECT_EQ(OctantGlyph(0x14), 0x1FBE6u);  // MIDDLE LEFT ONE QUARTER
  EXPECT_EQ(OctantGlyph(0x3F), 0x1FB85u);  // UPPER THREE QUARTERS
  EXPECT_EQ(OctantGlyph(0xC0), 0x2582u);   // LOWER ONE QUARTER
}

TEST(BrailleTest, DotsRunDownTheColumns) {
  EXPECT_EQ(BrailleGlyph(0), 0x2800u);
  EXPECT_EQ(BrailleGlyph(0x01), U'⠁');  // Dot 1: top left.
  EXPECT_EQ(BrailleGlyph(0x02), U'⠈');  // Dot 4: top right.
  EXPECT_EQ(BrailleGlyph(0x10), U'⠄');  // Dot 3: left, third row.
  EXPECT_EQ(BrailleGlyph(0x40), U'⡀');  // Dot 7: bottom left.
  EXPECT_EQ(BrailleGlyph(0x80), U'⢀');  // Dot 8: bottom right.
  EXPECT_EQ(BrailleGlyph(0xFF), 0x28FFu);
}

TEST(PatternTest, EveryPatternHasAGlyphOfItsOwn) {
  std::set<char32_t> sextants, octants, braille;
  for (unsigned pattern = 0; pattern < 256; ++pattern) {
    octants.insert(OctantGlyph(pattern));
    braille.insert(BrailleGlyph(pattern));
    if (pattern < 64) sextants.insert(SextantGlyph(pattern));
  }
  EXPECT_EQ(sextants.size(), 64u);
  EXPECT_EQ(octants.size(), 256u);
  EXPECT_EQ(braille.size(), 256u);
}

TEST(PatternTest, FindsTheCoarsestPattern) {
  const auto half = PatternOf(U'▌');
  ASSERT_TRUE(half);
  EXPECT_EQ(half->rows, 2);
  EXPECT_EQ(half->pattern, 5u);
  const auto sextant = PatternOf(0x1FB13);
  ASSERT_TRUE(sextant);
  EXPECT_EQ(sextant->rows, 3);
  EXPECT_EQ(sextant->pattern, 20u);
  const auto octant = PatternOf(0x1CDE5);
  ASSERT_TRUE(octant);
  EXPECT_EQ(octant->rows, 4);
  EXPECT_EQ(octant->pattern, 0xFEu);
  EXPECT_FALSE(PatternOf(U'A'));
  EXPECT_FALSE(PatternOf(U'▁'));
}

}  // namespace
}  // namespace rtb
