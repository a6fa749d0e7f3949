#include "encoders/palette.h"

#include <gtest/gtest.h>

#include <tuple>

namespace rtb {
namespace {

// xterm's resources: green3, blue2, gray90, "rgb:5c/5c/ff", white.
TEST(PaletteTest, StartsWithXtermsAnsiColors) {
  EXPECT_EQ(XtermColor(0), (Rgb8{0, 0, 0}));
  EXPECT_EQ(XtermColor(2), (Rgb8{0, 205, 0}));
  EXPECT_EQ(XtermColor(4), (Rgb8{0, 0, 238}));
  EXPECT_EQ(XtermColor(7), (Rgb8{229, 229, 229}));
  EXPECT_EQ(XtermColor(12), (Rgb8{92, 92, 255}));
  EXPECT_EQ(XtermColor(15), (Rgb8{255, 255, 255}));
}

// 16 + 36 r + 6 g + b with the levels 0, 95, 135, 175, 215, 255.
TEST(PaletteTest, GoesOnWithACube) {
  EXPECT_EQ(XtermColor(16), (Rgb8{0, 0, 0}));
  EXPECT_EQ(XtermColor(16 + 36 * 1 + 6 * 2 + 3), (Rgb8{95, 135, 175}));
  EXPECT_EQ(XtermColor(16 + 36 * 4 + 6 * 0 + 5), (Rgb8{215, 0, 255}));
  EXPECT_EQ(XtermColor(231), (Rgb8{255, 255, 255}));
}

TEST(PaletteTest, EndsWithGraysFrom8To238) {
  EXPECT_EQ(XtermColor(232), (Rgb8{8, 8, 8}));
  EXPECT_EQ(XtermColor(244), (Rgb8{128, 128, 128}));
  EXPECT_EQ(XtermColor(255), (Rgb8{238, 238, 238}));
}

// All different, or an index could not be told from a color; and the indices
// 0..15, which differ between terminals, are never among the 256.
TEST(PaletteTest, EveryColorHasItsIndex) {
  for (const auto& [depth, first, count] :
       {std::tuple{ColorDepth::k256, 16, std::size_t{240}},
        std::tuple{ColorDepth::k16, 0, std::size_t{16}}}) {
    const auto colors = PaletteColors(depth);
    ASSERT_EQ(colors.size(), count);
    for (std::size_t i = 0; i < count; ++i) {
      const int index = first + static_cast<int>(i);
      EXPECT_EQ(colors[i], XtermColor(index));
      EXPECT_EQ(IndexOf(colors[i], depth), index);
    }
  }
}

TEST(PaletteTest, OtherColorsHaveNone) {
  EXPECT_FALSE(IndexOf({1, 2, 3}, ColorDepth::k256));
  EXPECT_FALSE(IndexOf({205, 0, 0}, ColorDepth::k256));  // Color 1 alone.
  EXPECT_FALSE(IndexOf({95, 135, 175}, ColorDepth::k16));
  EXPECT_FALSE(IndexOf({255, 0, 0}, ColorDepth::kTruecolor));
  EXPECT_FALSE(IndexOf(kDefaultForeground, ColorDepth::kMono));
  EXPECT_TRUE(PaletteColors(ColorDepth::kTruecolor).empty());
  EXPECT_EQ(PaletteColors(ColorDepth::kMono).size(), 2u);
}

}  // namespace
}  // namespace rtb
