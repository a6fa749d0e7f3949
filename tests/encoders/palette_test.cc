#include "encoders/palette.h"

#include <gtest/gtest.h>

#include <set>

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

}  // namespace
}  // namespace rtb
