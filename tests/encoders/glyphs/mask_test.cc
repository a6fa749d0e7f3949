#include "encoders/glyphs/mask.h"

#include <gtest/gtest.h>

#include <bit>
#include <numeric>

#include "encoders/glyphs/patterns.h"
#include "tests/encoders/glyphs/mask_text.h"

namespace rtb {
namespace {

struct Size {
  int width, height;
};
constexpr Size kSizes[] = {{8, 16}, {1, 1}, {7, 13}, {5, 9}, {10, 20}};

/// Share of the cell that a glyph covers.
double Area(char32_t glyph, Size size) {
  const Mask mask = MaskOf(glyph, size.width, size.height);
  return std::accumulate(mask.coverage.begin(), mask.coverage.end(), 0.0) /
         (size.width * size.height);
}

TEST(MaskTest, AreasAreWhatTheNamesSayAtAnySize) {
  for (const Size size : kSizes) {
    EXPECT_EQ(Area(U' ', size), 0);
    EXPECT_EQ(Area(U'\u00A0', size), 0);
    EXPECT_NEAR(Area(U'▀', size), 0.5, 1e-6);
    EXPECT_NEAR(Area(U'▔', size), 0.125, 1e-6);
    EXPECT_NEAR(Area(U'▕', size), 0.125, 1e-6);
    EXPECT_NEAR(Area(U'▐', size), 0.5, 1e-6);
    for (char32_t i = 1; i <= 8; ++i) {
      EXPECT_NEAR(Area(0x2580 + i, size), i / 8.0, 1e-6);  // Lower.
      EXPECT_NEAR(Area(0x2590 - i, size), i / 8.0, 1e-6);  // Left.
    }
    for (char32_t i = 1; i <= 3; ++i) {
      EXPECT_NEAR(Area(0x2590 + i, size), i / 4.0, 1e-6);  // Shades.
    }
    for (const char32_t line : {0x23BA, 0x23BB, 0x23BC, 0x23BD}) {
      EXPECT_NEAR(Area(line, size), 1 / 9.0, 1e-6);
    }
  }
}

TEST(MaskTest, PatternsCoverTheirShareAtAnySize) {
  for (const Size size : kSizes) {
    for (unsigned pattern = 0; pattern < 256; ++pattern) {
      const double bits = std::popcount(pattern);
      EXPECT_NEAR(Area(OctantGlyph(pattern), size), bits / 8, 1e-6);
      if (pattern < 64) {
        EXPECT_NEAR(Area(SextantGlyph(pattern), size), bits / 6, 1e-6);
      }
      if (pattern < 16) {
        EXPECT_NEAR(Area(QuadrantGlyph(pattern), size), bits / 4, 1e-6);
      }
    }
  }
}

/// Expects the coverages of two glyphs to add up to 1 in each sub-pixel.
void ExpectComplements(char32_t a, char32_t b) {
  for (const Size size : kSizes) {
    const Mask first = MaskOf(a, size.width, size.height);
    const Mask second = MaskOf(b, size.width, size.height);
    for (std::size_t i = 0; i < first.coverage.size(); ++i) {
      ASSERT_NEAR(first.coverage[i] + second.coverage[i], 1, 1e-6)
          << static_cast<unsigned>(a) << " " << static_cast<unsigned>(b);
    }
  }
}

TEST(MaskTest, ComplementsAddUpToOneEverywhere) {
  ExpectComplements(U'▔', U'▇');
  ExpectComplements(U'▕', U'▉');
  ExpectComplements(U'░', U'▓');
  for (unsigned pattern = 0; pattern < 256; ++pattern) {
    ExpectComplements(OctantGlyph(pattern), OctantGlyph(pattern ^ 255));
    if (pattern < 64) {
      ExpectComplements(SextantGlyph(pattern), SextantGlyph(pattern ^ 63));
    }
    if (pattern < 16) {
      ExpectComplements(QuadrantGlyph(pattern), QuadrantGlyph(pattern ^ 15));
    }
  }
}

// SEXTANT-16: top left and bottom right of 2 x 3.
TEST(MaskTest, DrawsSextants) {
  EXPECT_EQ(Text(MaskOf(SextantGlyph(0x21), 4, 6)),
            "##..\n##..\n....\n....\n..##\n..##\n");
}

// OCTANT-458: right of row 2, left of row 3, right of row 4.
TEST(MaskTest, DrawsOctants) {
  EXPECT_EQ(Text(MaskOf(OctantGlyph(0x98), 2, 4)), "..\n.#\n#.\n.#\n");
}

TEST(MaskTest, DrawsQuadrants) {
  EXPECT_EQ(Text(MaskOf(U'▚', 4, 4)), "##..\n##..\n..##\n..##\n");
}

// Five eighths of 4 columns end in the middle of the third.
TEST(MaskTest, DrawsPartsOfSubPixels) {
  EXPECT_EQ(Text(MaskOf(U'▋', 4, 2)), "##5.\n##5.\n");
  // Sixths of 4 rows: a third is one row and a third of the next.
  EXPECT_EQ(Text(MaskOf(SextantGlyph(3), 2, 4)), "##\n33\n..\n..\n");
  EXPECT_EQ(Text(MaskOf(U'▒', 2, 1)), "55\n");
}

TEST(ShapeTest, OnlyPartsOfTheCellHaveShapes) {
  EXPECT_FALSE(ShapeOf(U'A'));
  EXPECT_FALSE(ShapeOf(U'│'));
  EXPECT_FALSE(ShapeOf(0x2800));
}

}  // namespace
}  // namespace rtb
