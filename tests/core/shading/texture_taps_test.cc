#include "core/shading/texture_taps.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rtb {
namespace {

TEST(PrincipalAxesTest, OfAxesAtRightAngles) {
  const EllipseAxes wide = PrincipalAxes(V2f(3, 0), V2f(0, -2));
  EXPECT_FLOAT_EQ(wide.longer, 9);
  EXPECT_FLOAT_EQ(wide.shorter, 4);
  EXPECT_NEAR(std::abs(wide.direction.x), 1, 1e-6f);
  const EllipseAxes high = PrincipalAxes(V2f(3, 0), V2f(0, 5));
  EXPECT_FLOAT_EQ(high.longer, 25);
  EXPECT_NEAR(std::abs(high.direction.y), 1, 1e-6f);
  const EllipseAxes turned = PrincipalAxes(V2f(3, 3), V2f(1, -1));
  EXPECT_FLOAT_EQ(turned.longer, 18);
  EXPECT_FLOAT_EQ(turned.shorter, 2);
  EXPECT_NEAR(turned.direction.x, turned.direction.y, 1e-6f);
}

// The image of a circle under (x, y) -> (x + y, y): the squared axes are the
// eigenvalues of [[2, 1], [1, 1]], (3 +- sqrt 5) / 2, whose eigenvector is
// (golden ratio, 1).
TEST(PrincipalAxesTest, OfConjugateDiameters) {
  const EllipseAxes axes = PrincipalAxes(V2f(1, 0), V2f(1, 1));
  EXPECT_NEAR(axes.longer, (3 + std::sqrt(5.0f)) / 2, 1e-5f);
  EXPECT_NEAR(axes.shorter, (3 - std::sqrt(5.0f)) / 2, 1e-5f);
  EXPECT_NEAR(axes.direction.x / axes.direction.y, 1.618034f, 1e-4f);
}

TEST(TextureTapsTest, TakesOneLookupBelowATexel) {
  const TextureTaps taps =
      MakeTextureTaps({V2f(0.9f / 64, 0), V2f(0, 0.4f / 64)}, V2f(64), 7);
  EXPECT_EQ(taps.count, 1);
  EXPECT_EQ(taps.level, 0);
  EXPECT_EQ(taps.next, 0);
  EXPECT_EQ(taps.first, V2f(0, 0));
}

// A width of sqrt(3) 2^k texels is as wide as level k; the last level ends it.
TEST(TextureTapsTest, LevelsFollowTheWidth) {
  for (int level = 1; level <= 8; ++level) {
    const float width =
        1.0001f * std::sqrt(3.0f) * std::exp2(static_cast<float>(level)) / 64;
    const TextureTaps taps =
        MakeTextureTaps({V2f(width, 0), V2f(0, width)}, V2f(64), 7);
    EXPECT_EQ(taps.count, 1);
    EXPECT_EQ(taps.level, std::min(level, 6));
    EXPECT_NEAR(taps.next, 0, 1e-3f);
  }
}

// sqrt(64^2 - 4^2) = 63.9 texels long, 4 / sqrt 3 = 2.31 a lookup: 28 would be
// needed, 16 there are, evenly around the middle.
TEST(TextureTapsTest, TakesSixteenAtMost) {
  const TextureTaps taps =
      MakeTextureTaps({V2f(0, 1), V2f(4.0f / 64, 0)}, V2f(64), 7);
  EXPECT_EQ(taps.count, 16);
  EXPECT_EQ(taps.level, 1);  // 63.9 / 16 = 3.99 texels
  const V2f middle = taps.first + taps.step * 7.5f;
  EXPECT_NEAR(middle.length(), 0, 1e-6f);
  EXPECT_NEAR(std::abs(taps.step.y), 63.9f / 16 / 64, 1e-3f);
}

}  // namespace
}  // namespace rtb
