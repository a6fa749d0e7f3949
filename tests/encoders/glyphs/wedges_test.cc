#include "encoders/glyphs/wedges.h"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/encoders/glyphs/mask_text.h"

namespace rtb {
namespace {

struct Size {
  int width, height;
};
constexpr Size kSizes[] = {{8, 16}, {1, 1}, {7, 13}, {4, 8}};

double AreaOf(const Mask& mask) {
  return std::accumulate(mask.coverage.begin(), mask.coverage.end(), 0.0) /
         (mask.width * mask.height);
}

// Triangles of half the cell's width or all of it, and one or two thirds or
// all of its height; U+1FB41-1FB45 are what the opposite ones leave. The last
// one is cut at half of its height in the mean.
TEST(WedgesTest, AreasFollowFromTheNames) {
  constexpr double kTwelfths[] = {1, 2, 2, 4, 3, 11, 10, 10, 8, 9, 6};
  for (const Size size : kSizes) {
    for (std::size_t i = 0; i < std::size(kTwelfths); ++i) {
      const auto glyph = static_cast<char32_t>(0x1FB3C + i);
      const Mask mask = MaskOf(glyph, size.width, size.height);
      EXPECT_NEAR(AreaOf(mask), kTwelfths[i] / 12, 1e-7) << i;
    }
    for (char32_t glyph = 0x1FB68; glyph <= 0x1FB6F; ++glyph) {
      const Mask mask = MaskOf(glyph, size.width, size.height);
      EXPECT_NEAR(AreaOf(mask), glyph < 0x1FB6C ? 0.75 : 0.25, 1e-7);
    }
  }
}

// (0, 2/3) - (1/2, 1) cuts off the lower left of a 4 x 3 mask: 2 sub-pixels
// wide and 1 high, of which the first holds 3/4 and the second 1/4.
TEST(WedgesTest, LieInTheCornerThatTheyName) {
  EXPECT_EQ(Text(MaskOf(0x1FB3C, 4, 3)), "....\n....\n83..\n");
  EXPECT_EQ(Text(MaskOf(0x1FB41, 4, 3)), "38##\n####\n####\n");
  // (0, 2/3) - (1, 1/3), the lower right: 4 sub-pixels in the middle row hold
  // 1/8, 3/8, 5/8 and 7/8.
  EXPECT_EQ(Text(MaskOf(0x1FB46, 4, 3)), "....\n1469\n####\n");
  // (0, 0) - (1/2, 1), the lower left: x < y / 2.
  EXPECT_EQ(Text(MaskOf(0x1FB40, 2, 2)), "3.\n8.\n");
}

TEST(WedgesTest, TrianglesPointToTheMiddle) {
  EXPECT_EQ(Text(MaskOf(0x1FB6C, 4, 4)), "5...\n#5..\n#5..\n5...\n");
  EXPECT_EQ(Text(MaskOf(0x1FB6D, 4, 4)), "5##5\n.55.\n....\n....\n");
  EXPECT_EQ(Text(MaskOf(0x1FB6E, 4, 4)), "...5\n..5#\n..5#\n...5\n");
  EXPECT_EQ(Text(MaskOf(0x1FB6F, 4, 4)), "....\n....\n.55.\n5##5\n");
}

/// Expects b to be a, mirrored from left to right.
void ExpectMirrored(char32_t a, char32_t b) {
  const Mask first = MaskOf(a, 8, 16);
  const Mask second = MaskOf(b, 8, 16);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 8; ++x) {
      ASSERT_NEAR(first.at(x, y), second.at(7 - x, y), 1e-6)
          << std::hex << static_cast<unsigned>(a);
    }
  }
}

/// Expects b to cover what a leaves free.
void ExpectComplement(char32_t a, char32_t b) {
  const Mask first = MaskOf(a, 7, 13);
  const Mask second = MaskOf(b, 7, 13);
  for (std::size_t i = 0; i < first.coverage.size(); ++i) {
    ASSERT_NEAR(first.coverage[i] + second.coverage[i], 1, 1e-6)
        << std::hex << static_cast<unsigned>(a);
  }
}

// The names of U+1FB47-1FB51 change LEFT and RIGHT of those of U+1FB3C-1FB46;
// those of U+1FB52-1FB67 name the other side of the same diagonals.
TEST(WedgesTest, MirrorsAndComplementsAreWhereTheNamesSay) {
  for (char32_t i = 0; i < 11; ++i) ExpectMirrored(0x1FB3C + i, 0x1FB47 + i);
  for (char32_t i = 0; i < 22; ++i) ExpectComplement(0x1FB3C + i, 0x1FB52 + i);
  for (char32_t i = 0; i < 4; ++i) ExpectComplement(0x1FB68 + i, 0x1FB6C + i);
}

TEST(WedgesTest, AreNoOtherGlyphs) {
  EXPECT_FALSE(WedgeOf(0x1FB3B));
  EXPECT_FALSE(WedgeOf(0x1FB70));
  EXPECT_FALSE(WedgeOf(U' '));
}

}  // namespace
}  // namespace rtb
