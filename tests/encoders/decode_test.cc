#include "encoders/decode.h"

#include <gtest/gtest.h>

#include "tests/encoders/testing.h"

namespace rtb {
namespace {

constexpr Rgb8 kFore{255, 102, 0};
constexpr Rgb8 kBack{0, 51, 255};

CellGrid OneCell(char32_t glyph) {
  CellGrid grid({1, 1});
  grid.cells[0] = {glyph, kFore, kBack};
  return grid;
}

TEST(DecodeTest, PutsEveryCellInItsPlace) {
  CellGrid grid({2, 2});
  for (std::uint8_t i = 0; i < 4; ++i) {
    grid.cells[i] = {U' ', {}, {i, i, i}};
  }
  DecodeOptions options;
  options.cell_width = 3;
  options.cell_height = 5;
  const auto image = Decode(grid, options);
  ASSERT_TRUE(image);
  ASSERT_EQ(image->width(), 6);
  ASSERT_EQ(image->height(), 10);
  for (int y = 0; y < 10; ++y) {
    for (int x = 0; x < 6; ++x) {
      const float code = static_cast<float>(y / 5 * 2 + x / 3);
      EXPECT_EQ(image->at(x, y), Rgb(code / 255)) << x << "," << y;
    }
  }
}

TEST(DecodeTest, BlocksTakeTheirExactPart) {
  const auto image = Decode(OneCell(U'▗'), {});
  ASSERT_TRUE(image);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 8; ++x) {
      const bool on = x >= 4 && y >= 8;
      EXPECT_EQ(image->at(x, y), EncodedValues(on ? kFore : kBack));
    }
  }
}

// Three eighths of 4 pixels: one and a half. The mixed row lies halfway
// between the encoded colors, unrounded: (255 + 0, 102 + 51, 0 + 255) / 510.
TEST(DecodeTest, PartlyCoveredPixelsMixEncodedColors) {
  DecodeOptions options;
  options.cell_width = 2;
  options.cell_height = 4;
  const auto image = Decode(OneCell(U'▃'), options);
  ASSERT_TRUE(image);
  EXPECT_EQ(image->at(0, 1), EncodedValues(kBack));
  EXPECT_TRUE(image->at(0, 2).equalWithAbsError(Rgb(0.5f, 0.3f, 0.5f), 1e-7f));
  EXPECT_EQ(image->at(1, 3), EncodedValues(kFore));
}

TEST(DecodeTest, GlyphsThatNoFontHasAreErrors) {
  const auto image = Decode(OneCell(0x4E00), {});
  ASSERT_FALSE(image);
  EXPECT_EQ(image.error().kind, ErrorKind::kMissing);
  EXPECT_EQ(image.error().place, "U+4E00");
}

TEST(DecodeTest, DoesNotDependOnTheNumberOfThreads) {
  const CellGrid grid =
      EncodeValues("tiv", {9, 7}, RandomValues(9 * 7 * 32, 1));
  DecodeOptions options;
  options.threads = 1;
  const auto one = Decode(grid, options);
  options.threads = 3;
  const auto three = Decode(grid, options);
  ASSERT_TRUE(one && three);
  EXPECT_TRUE(std::ranges::equal(one->pixels(), three->pixels()));
}

}  // namespace
}  // namespace rtb
