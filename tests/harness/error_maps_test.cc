#include "harness/error_maps.h"

#include <gtest/gtest.h>

#include "core/color/srgb.h"

namespace rtb {
namespace {

Image Flat(Rgb color) {
  Image image(8, 6);
  for (Rgb& pixel : image.pixels()) pixel = color;
  return image;
}

// Black against white is FLIP's largest error, 1; equal images have none. The
// ends of magma: #000004 and #fcfdbf.
TEST(ErrorMapsTest, FlipGoesFromOneEndOfMagmaToTheOther) {
  const Image black = Flat(Rgb(0));
  const Image white = Flat(Rgb(1));
  const Image equal = FlipPicture(MetricInput(black, black));
  const Image opposite = FlipPicture(MetricInput(black, white));
  EXPECT_EQ(equal.width(), 8);
  EXPECT_EQ(equal.height(), 6);
  for (const Rgb& pixel : equal.pixels()) {
    ASSERT_EQ(pixel, EncodedValues(Rgb8{0, 0, 4}));
  }
  for (const Rgb& pixel : opposite.pixels()) {
    ASSERT_EQ(pixel, EncodedValues(Rgb8{252, 253, 191}));
  }
}

TEST(ErrorMapsTest, DifferencesAreAbsoluteAndPerChannel) {
  Image reference = Flat(Rgb(0.5f, 0.25f, 1));
  Image test = Flat(Rgb(0.25f, 0.5f, 1));
  test.at(3, 2) = Rgb(1, 0.25f, 0);
  const Image picture = DifferencePicture(MetricInput(reference, test));
  EXPECT_EQ(picture.at(0, 0), Rgb(0.25f, 0.25f, 0));
  EXPECT_EQ(picture.at(3, 2), Rgb(0.5f, 0, 1));
}

}  // namespace
}  // namespace rtb
