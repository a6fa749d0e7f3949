#include "encoders/glyphs/glyph_lists.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "encoders/glyphs/patterns.h"

namespace rtb {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<char32_t> Glyphs(const std::string& names) {
  auto glyphs = GlyphsOf(names);
  EXPECT_TRUE(glyphs) << glyphs.error().ToString();
  return glyphs ? *glyphs : std::vector<char32_t>();
}

TEST(GlyphListsTest, HoldSpaceAndFullBlockByRisingCodePoint) {
  EXPECT_THAT(Glyphs("blocks"),
              ElementsAre(U' ', U'▀', U'▄', U'█', U'▌', U'▐'));
  EXPECT_THAT(Glyphs("shades"), ElementsAre(U' ', U'█', U'░', U'▒', U'▓'));
}

// Space and full block, and: 7 + 7 + 2; 10; 60; 52; 230 + 10; 256; the 95
// printing characters, space among them; and of tiv's glyphs those that are no
// block elements: 22 of U+2500-257F, 6 of U+23xx, U+25AA.
TEST(GlyphListsTest, HaveTheirSizes) {
  EXPECT_EQ(Glyphs("eighths").size(), 18u);
  EXPECT_EQ(Glyphs("quadrants").size(), 12u);
  EXPECT_EQ(Glyphs("sextants").size(), 62u);
  EXPECT_EQ(Glyphs("wedges").size(), 54u);
  EXPECT_EQ(Glyphs("octants").size(), 242u);
  EXPECT_EQ(Glyphs("braille").size(), 258u);
  EXPECT_EQ(Glyphs("ascii").size(), 96u);
  EXPECT_EQ(Glyphs("box").size(), 31u);
  EXPECT_THAT(Glyphs("box"), testing::IsSupersetOf({U'│', U'⎢', U'▪', U'╋'}));
  EXPECT_THAT(Glyphs("box"), testing::Not(Contains(U'▖')));
  EXPECT_THAT(Glyphs("box"), testing::Not(Contains(U'\u00A0')));
}

// With blocks and quadrants, sextants and octants have a glyph for every
// pattern.
TEST(GlyphListsTest, CompleteTheOctants) {
  const auto glyphs = Glyphs("octants+blocks+quadrants+sextants");
  for (unsigned pattern = 0; pattern < 256; ++pattern) {
    EXPECT_THAT(glyphs, Contains(OctantGlyph(pattern)));
    EXPECT_THAT(glyphs, Contains(SextantGlyph(pattern % 64)));
  }
}

TEST(GlyphListsTest, AreUnitedOnce) {
  const auto once = Glyphs("blocks+quadrants");
  EXPECT_EQ(Glyphs("quadrants+blocks+quadrants"), once);
  EXPECT_EQ(once.size(), 16u);
}

TEST(GlyphListsTest, UnknownNamesListThePossibleOnes) {
  for (const char* const names : {"", "block", "blocks+", "blocks+octant"}) {
    const auto glyphs = GlyphsOf(names, "here");
    ASSERT_FALSE(glyphs) << names;
    EXPECT_EQ(glyphs.error().kind, ErrorKind::kBadInput);
    EXPECT_EQ(glyphs.error().place, "here");
    EXPECT_THAT(glyphs.error().what,
                HasSubstr("blocks, eighths, quadrants, shades, sextants, "
                          "wedges, octants, braille, box, ascii"));
  }
  EXPECT_EQ(GlyphsOf("octant").error().hint, "did you mean `octants`?");
}

}  // namespace
}  // namespace rtb
