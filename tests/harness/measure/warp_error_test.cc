#include "harness/measure/warp_error.h"

#include <gtest/gtest.h>

namespace rtb {
namespace {

/// Gray values 0, 1/4, 1/2, 3/4 in a row.
Image Ramp() {
  Image image(4, 1);
  for (int x = 0; x < 4; ++x) {
    image.at(x, 0) = Rgb(static_cast<float>(x) / 4);
  }
  return image;
}

/// Each pixel was `shift` pixels further left; the first was outside.
std::vector<PixelMotion> ShiftedBy(double shift) {
  std::vector<PixelMotion> motions(4);
  for (std::size_t x = 1; x < 4; ++x) {
    motions[x].place = V2d(static_cast<double>(x) + 0.5 - shift, 0.5);
    motions[x].sight = Sight::kVisible;
  }
  return motions;
}

TEST(InterpolateTest, IsLinearBetweenCentersAndFlatBeyond) {
  const Image ramp = Ramp();
  EXPECT_DOUBLE_EQ(Interpolate(ramp, {1.5, 0.5}).x, 0.25);
  EXPECT_DOUBLE_EQ(Interpolate(ramp, {2.25, 0.5}).y, 0.25 + 0.75 * 0.25);
  EXPECT_DOUBLE_EQ(Interpolate(ramp, {0.1, 0.9}).z, 0);
  EXPECT_DOUBLE_EQ(Interpolate(ramp, {4, 0}).x, 0.75);
}

// Of three visible pixels each was darker by half a step, 1/8, half a pixel to
// the left.
TEST(WarpErrorTest, IsTheMeanChangeOfVisiblePixels) {
  WarpError error;
  error.Add(Ramp(), Ramp(), ShiftedBy(0.5));
  EXPECT_DOUBLE_EQ(error.Mean().value(), 0.125);
  error.Add(Ramp(), Ramp(), ShiftedBy(0));
  EXPECT_DOUBLE_EQ(error.Mean().value(), 0.0625);
}

// A picture that moves as the motion says has no error.
TEST(WarpErrorTest, FollowsTheMotion) {
  Image moved(4, 1);
  for (int x = 1; x < 4; ++x) moved.at(x, 0) = Ramp().at(x - 1, 0);
  WarpError error;
  error.Add(moved, Ramp(), ShiftedBy(1));
  EXPECT_DOUBLE_EQ(error.Mean().value(), 0);
}

TEST(WarpErrorTest, LeavesOutWhatWasHidden) {
  std::vector<PixelMotion> motions(4);
  for (PixelMotion& motion : motions) motion.sight = Sight::kHidden;
  WarpError error;
  error.Add(Ramp(), Ramp(), motions);
  EXPECT_EQ(error.Mean(), std::nullopt);
}

}  // namespace
}  // namespace rtb
