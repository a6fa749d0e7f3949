#include <gtest/gtest.h>

#include <limits>

#include "tests/core/shading/light_tools.h"

namespace rtb {
namespace {

LightData MakePoint(const V3d& position, bool inverse_square) {
  return ToLightData(
      {"", PointLight{position, Rgb(12), inverse_square}, kNone, {}}, V3d(0));
}

/// At (0, 4, 0), shining down with intensity 10.
LightData MakeSpot(double cone, double penumbra) {
  return ToLightData(
      {"",
       SpotLight{V3d(0, 4, 0), V3d(0, -3, 0), Rgb(10), cone, penumbra},
       kNone,
       {}},
      V3d(0));
}

const V3f kUp(0, 1, 0);

// On the plane y = 0 at (3, 0, 0), below a light at height 4: d = 5 and
// cos = 4/5, so I cos / d^2 = 12 * 0.8 / 25, and without falloff 12 * 0.8.
TEST(PointLightTest, IrradianceOnAPlane) {
  const V3f at(3, 0, 0);
  EXPECT_NEAR(Irradiance(MakePoint(V3d(0, 4, 0), true), at, kUp, 1),
              12 * 0.8 / 25, 1e-7);
  EXPECT_NEAR(Irradiance(MakePoint(V3d(0, 4, 0), false), at, kUp, 1), 12 * 0.8,
              1e-6);
  const LightSample s = SampleLight(MakePoint(V3d(0, 4, 0), true), at);
  EXPECT_FLOAT_EQ(s.distance, 5);
  EXPECT_EQ(s.pdf, 0);
}

TEST(PointLightTest, BlackAtTheLightItself) {
  EXPECT_EQ(SampleLight(MakePoint(V3d(1, 2, 3), true), V3f(1, 2, 3)).irradiance,
            Rgb(0));
}

TEST(DirectionalLightTest, TheSameEverywhere) {
  const LightData sun = ToLightData(
      {"", DirectionalLight{V3d(0, -2, 0), Rgb(3)}, kNone, {}}, V3d(9));
  const LightSample s = SampleLight(sun, V3f(1e6f));
  EXPECT_EQ(s.direction, kUp);
  EXPECT_EQ(s.distance, std::numeric_limits<float>::infinity());
  EXPECT_EQ(s.irradiance, Rgb(3));
  EXPECT_EQ(s.pdf, 0);
}

/// On the plane y = 0 below the spot, `degrees` off its axis.
double SpotIrradiance(const LightData& spot, double degrees) {
  const double x = 4 * std::tan(degrees * kPiExact / 180);
  return Irradiance(spot, V3f(static_cast<float>(x), 0, 0), kUp, 1);
}

/// Of the full intensity there: I cos / d^2 with d = 4 / cos.
double FullIrradiance(double degrees) {
  return 10 * std::pow(std::cos(degrees * kPiExact / 180), 3) / 16;
}

TEST(SpotLightTest, FullWithinTheCone) {
  const LightData spot = MakeSpot(30, 8);
  for (const double angle : {0.0, 10.0, 29.99}) {
    EXPECT_NEAR(SpotIrradiance(spot, angle), FullIrradiance(angle), 1e-6);
  }
}

// Smoothstep in the angle: at 1/4 of the penumbra 1 - (3/16 - 2/64) = 27/32,
// at the half 1/2, at 3/4 5/32, and nothing at its end.
TEST(SpotLightTest, SmoothstepInTheAngleOverThePenumbra) {
  const LightData spot = MakeSpot(30, 8);
  EXPECT_NEAR(SpotIrradiance(spot, 32), FullIrradiance(32) * 27 / 32, 1e-6);
  EXPECT_NEAR(SpotIrradiance(spot, 34), FullIrradiance(34) / 2, 1e-6);
  EXPECT_NEAR(SpotIrradiance(spot, 36), FullIrradiance(36) * 5 / 32, 1e-6);
  EXPECT_EQ(SpotIrradiance(spot, 38.01), 0);
  EXPECT_EQ(SpotIrradiance(spot, 80), 0);
}

TEST(SpotLightTest, WithoutPenumbraTheEdgeIsSharp) {
  const LightData spot = MakeSpot(30, 0);
  EXPECT_NEAR(SpotIrradiance(spot, 29.99), FullIrradiance(29.99), 1e-6);
  EXPECT_EQ(SpotIrradiance(spot, 30.01), 0);
}

// A cone of a hundredth of a degree: cosines of such angles are all alike in
// single precision, the angles are not.
TEST(SpotLightTest, NarrowConesArePrecise) {
  const LightData spot = MakeSpot(0.01, 0.01);
  EXPECT_NEAR(SpotIrradiance(spot, 0.009), FullIrradiance(0), 1e-5);
  EXPECT_NEAR(SpotIrradiance(spot, 0.015), FullIrradiance(0) / 2, 1e-4);
  EXPECT_EQ(SpotIrradiance(spot, 0.021), 0);
}

TEST(SpotLightTest, NothingBehindIt) {
  EXPECT_EQ(SampleLight(MakeSpot(30, 8), V3f(0, 9, 0)).irradiance, Rgb(0));
  EXPECT_EQ(SampleLight(MakeSpot(30, 8), V3f(0, 4, 0)).irradiance, Rgb(0));
}

TEST(PointLightTest, WithoutExtentNothingIsHit) {
  for (const LightData& light : {MakePoint(V3d(0), true), MakeSpot(30, 8)}) {
    EXPECT_FALSE(HasExtent(light));
    EXPECT_EQ(LightPdf(light, V3f(0, 0, 0), kUp, 4), 0);
    EXPECT_EQ(EmittedRadiance(light, -kUp, kUp), Rgb(0));
  }
}

}  // namespace
}  // namespace rtb
