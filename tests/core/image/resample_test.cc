#include "core/image/resample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace rtb {
namespace {

/// Red is 1 + x, green 10 y, blue 1/3 everywhere.
Image Ramp(int width, int height) {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.at(x, y) = Rgb(1.0f + static_cast<float>(x),
                           10.0f * static_cast<float>(y), 1.0f / 3);
    }
  }
  return image;
}

TEST(BoxMean, PixelsCoveredExactlyComeOutExactly) {
  const Image image = Ramp(5, 4);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 5; ++x) {
      EXPECT_EQ(BoxMean(image, x, y, x + 1, y + 1), image.at(x, y));
    }
  }
}

// Red over [0.5, 2.5): (0.5 * 1 + 2 + 0.5 * 3) / 2 = 2. Green over
// [0.25, 1.25): 0.75 * 0 + 0.25 * 10 = 2.5.
TEST(BoxMean, WeighsByTheAreaCovered) {
  const Rgb mean = BoxMean(Ramp(5, 4), 0.5, 0.25, 2.5, 1.25);
  EXPECT_FLOAT_EQ(mean.x, 2.0f);
  EXPECT_FLOAT_EQ(mean.y, 2.5f);
  EXPECT_FLOAT_EQ(mean.z, 1.0f / 3);
}

// Within one pixel, however small the box.
TEST(BoxMean, PartsOfAPixelHaveItsValue) {
  const Image image = Ramp(5, 4);
  EXPECT_EQ(BoxMean(image, 3.25, 2.5, 3.375, 2.75), image.at(3, 2));
  const Rgb tiny = BoxMean(image, 3.25, 2.5, 3.25 + 1e-7, 2.5 + 1e-7);
  EXPECT_NEAR(tiny.x, 4, 1e-5);
  // Narrower than the tolerance, and upon a border: half of each pixel.
  const Rgb border = BoxMean(image, 3 - 1e-7, 2.25, 3 + 1e-7, 2.5);
  EXPECT_NEAR(border.x, 3.5, 1e-5);
}

TEST(BoxMean, OutsideIsBlack) {
  const Image image = Ramp(5, 4);
  // Half of the box lies left of the image: (0 + 1) / 2.
  EXPECT_FLOAT_EQ(BoxMean(image, -1, 0, 1, 1).x, 0.5f);
  // A quarter of it covers the last pixel: 5 / 4 and 30 / 4.
  EXPECT_FLOAT_EQ(BoxMean(image, 4, 3, 6, 5).x, 1.25f);
  EXPECT_FLOAT_EQ(BoxMean(image, 4, 3, 6, 5).y, 7.5f);
  EXPECT_EQ(BoxMean(image, 7, 7, 9, 9), Rgb(0));
  EXPECT_EQ(BoxMean(image, -1e12, -9, -1e11, -8), Rgb(0));
}

// Positions in single precision miss a border by a little; what lies across
// it must not be touched.
TEST(BoxMean, SnapsToBordersNearby) {
  Image image(3, 1);
  image.at(0, 0) = Rgb(std::numeric_limits<float>::infinity());
  image.at(1, 0) = Rgb(0.1f, 0.2f, 0.3f);
  image.at(2, 0) = Rgb(std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(BoxMean(image, 1 - 2e-6, -1e-6, 2 + 2e-6, 1 + 1e-6),
            image.at(1, 0));
}

TEST(BoxMeanDeathTest, NeedsAnArea) {
  EXPECT_DEATH(BoxMean(Ramp(2, 2), 1, 0, 1, 1), "x0 < x1");
  EXPECT_DEATH(BoxMean(Ramp(2, 2), 0, 1, 1, 0), "y0 < y1");
}

TEST(ResizeArea, SameSizeIsTheSameImage) {
  const Image image = Ramp(7, 3);
  const Image resized = ResizeArea(image, 7, 3);
  EXPECT_TRUE(std::ranges::equal(image.pixels(), resized.pixels()));
}

TEST(ResizeArea, HalvesByMeansOfFour) {
  const Image resized = ResizeArea(Ramp(4, 2), 2, 1);
  ASSERT_EQ(resized.width(), 2);
  ASSERT_EQ(resized.height(), 1);
  EXPECT_FLOAT_EQ(resized.at(0, 0).x, 1.5f);  // of 1 and 2
  EXPECT_FLOAT_EQ(resized.at(1, 0).x, 3.5f);  // of 3 and 4
  EXPECT_FLOAT_EQ(resized.at(0, 0).y, 5.0f);  // of 0 and 10
}

// 3 to 2: each takes a pixel and a half: (1 + 0.5 * 2) / 1.5 = 4/3 and
// (0.5 * 2 + 3) / 1.5 = 8/3.
TEST(ResizeArea, SplitsPixels) {
  const Image resized = ResizeArea(Ramp(3, 1), 2, 1);
  EXPECT_FLOAT_EQ(resized.at(0, 0).x, 4.0f / 3);
  EXPECT_FLOAT_EQ(resized.at(1, 0).x, 8.0f / 3);
}

TEST(ResizeArea, EnlargesByRepeating) {
  const Image image = Ramp(3, 2);
  const Image resized = ResizeArea(image, 9, 4);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 9; ++x) {
      EXPECT_EQ(resized.at(x, y), image.at(x / 3, y / 2));
    }
  }
}

TEST(ResizeArea, KeepsTheMean) {
  const Image image = Ramp(13, 11);
  const Rgb all = BoxMean(image, 0, 0, 13, 11);
  const Image resized = ResizeArea(image, 5, 7);
  const Rgb mean = BoxMean(resized, 0, 0, 5, 7);
  EXPECT_NEAR(mean.x, all.x, 1e-5);
  EXPECT_NEAR(mean.y, all.y, 1e-4);
  EXPECT_NEAR(mean.z, all.z, 1e-6);
}

}  // namespace
}  // namespace rtb
