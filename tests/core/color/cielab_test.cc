#include "core/color/cielab.h"

#include <gtest/gtest.h>

#include "core/color/luminance.h"

namespace rtb {
namespace {

void ExpectNear(const V3d& value, const V3d& expected, double tolerance) {
  EXPECT_NEAR(value.x, expected.x, tolerance);
  EXPECT_NEAR(value.y, expected.y, tolerance);
  EXPECT_NEAR(value.z, expected.z, tolerance);
}

TEST(CielabTest, WhiteIsTheWhitePoint) {
  ExpectNear(LinearToXyz({1, 1, 1}), {kWhiteX, kWhiteY, kWhiteZ}, 5e-9);
}

TEST(CielabTest, XyzRoundTrip) {
  const V3d color(0.1, 0.7, 0.4);
  ExpectNear(XyzToLinear(LinearToXyz(color)), color, 1e-14);
}

TEST(CielabTest, GraysHaveNoChroma) {
  ExpectNear(LinearToLab({0, 0, 0}), {0, 0, 0}, 1e-12);
  // Y = 18 %: L* = 116 x 0.18^(1/3) - 16 = 49.496.
  ExpectNear(LinearToLab({0.18, 0.18, 0.18}), {49.496, 0, 0}, 1e-3);
  ExpectNear(LinearToLab({1, 1, 1}), {100, 0, 0}, 1e-6);
  // Below (6/29)^3 the curve is a line: L* = (29/3)^3 Y = 903.3 Y.
  ExpectNear(LinearToLab({0.001, 0.001, 0.001}), {0.9033, 0, 0}, 1e-4);
}

// Published values of sRGB's red for D65, 2 degrees: 53.24, 80.09, 67.20.
TEST(CielabTest, Red) {
  ExpectNear(LinearToLab({1, 0, 0}), {53.24, 80.09, 67.20}, 0.02);
}

TEST(LuminanceTest, WeighsLikeBt709) {
  EXPECT_DOUBLE_EQ(Luminance(V3d(1, 0, 0)), 0.2126);
  EXPECT_DOUBLE_EQ(Luminance(V3d(0, 1, 0)), 0.7152);
  EXPECT_DOUBLE_EQ(Luminance(V3d(0, 0, 1)), 0.0722);
  EXPECT_NEAR(Luminance(V3f(1, 1, 1)), 1, 1e-6);
}

}  // namespace
}  // namespace rtb
