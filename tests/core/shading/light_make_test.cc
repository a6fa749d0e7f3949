#include "core/shading/light_make.h"

#include <gtest/gtest.h>

#include "tests/core/shading/light_tools.h"

namespace rtb {
namespace {

TEST(LightMakeTest, PathsMoveWhatHasAPlace) {
  const V3d offset(1, 2, 3);
  const Light point{"", PointLight{V3d(1, 0, 0), Rgb(1), true}, kNone, {}};
  EXPECT_EQ(ToLightData(point, offset).position, V3f(2, 2, 3));
  const Light spot{"", SpotLight{V3d(1, 0, 0)}, kNone, {}};
  EXPECT_EQ(ToLightData(spot, offset).position, V3f(2, 2, 3));
  const Light quad{
      "", QuadLight{V3d(1, 0, 0), {V3d(1, 0, 0), V3d(0, 1, 0)}}, kNone, {}};
  EXPECT_EQ(ToLightData(quad, offset).position, V3f(2, 2, 3));
  EXPECT_EQ(ToLightData(quad, offset).edge0, V3f(1, 0, 0));
  const Light sphere{"", SphereLight{V3d(1, 0, 0)}, kNone, {}};
  EXPECT_EQ(ToLightData(sphere, offset).position, V3f(2, 2, 3));
  const Light sun{"", DirectionalLight{V3d(0, 0, -5)}, kNone, {}};
  EXPECT_EQ(ToLightData(sun, offset).direction, V3f(0, 0, -1));
}

TEST(LightMakeTest, AnglesBecomeRadiansAndSamplesPass) {
  const Light spot{
      "", SpotLight{V3d(0), V3d(0, -1, 0), Rgb(1), 60, 30}, kNone, {}};
  EXPECT_FLOAT_EQ(ToLightData(spot, V3d(0)).cone,
                  static_cast<float>(kPiExact / 3));
  EXPECT_FLOAT_EQ(ToLightData(spot, V3d(0)).penumbra,
                  static_cast<float>(kPiExact / 6));
  const Light sphere{"", SphereLight{V3d(0), 1, Rgb(1), 16}, kNone, {}};
  EXPECT_EQ(ToLightData(sphere, V3d(0)).samples, 16);
}

TEST(LightMakeTest, FlatLightsKnowTheirAreaAndNormalAtAnySize) {
  for (const double size : {1e-12, 1.0, 1e12}) {
    const LightData quad =
        MakeQuad(V3d(0), V3d(2, 0, 0) * size, V3d(1, 3, 0) * size, Rgb(1));
    EXPECT_EQ(quad.direction, V3f(0, 0, 1));
    EXPECT_FLOAT_EQ(quad.area, static_cast<float>(6 * size * size));
    EXPECT_FALSE(quad.rectangle);
  }
  const LightData triangle =
      TriangleLight(V3f(0), V3f(0, 0, 2), V3f(0, 3, 0), Rgb(1));
  EXPECT_FLOAT_EQ(triangle.area, 3);
  EXPECT_EQ(triangle.direction, V3f(-1, 0, 0));
}

// A lamp's power: pi L per unit of Lambertian area, 4 pi I of a point, and the
// spot's share of the sphere; with R = 2 a sun lights pi R^2 = 4 pi.
TEST(LightMakeTest, PowerIsTheFlux) {
  const auto power = [](const auto& light) {
    return LightPower(ToLightData({"", light, kNone, {}}, V3d(0)), 2);
  };
  EXPECT_NEAR(power(PointLight{V3d(0), Rgb(5), true}), 20 * kPiExact, 1e-4);
  EXPECT_NEAR(power(DirectionalLight{V3d(0, 1, 0), Rgb(5)}), 20 * kPiExact,
              1e-4);
  EXPECT_NEAR(power(SpotLight{V3d(0), V3d(0, 1, 0), Rgb(5), 60, 0}),
              5 * 2 * kPiExact * 0.5, 1e-4);
  EXPECT_NEAR(power(SphereLight{V3d(0), 3, Rgb(5)}),
              5 * kPiExact * 36 * kPiExact, 1e-3);
  EXPECT_NEAR(power(QuadLight{V3d(0), {V3d(2, 0, 0), V3d(0, 0, 3)}, Rgb(5)}),
              5 * kPiExact * 6, 1e-4);
  const LightData triangle =
      TriangleLight(V3f(0), V3f(0, 0, 2), V3f(0, 3, 0), Rgb(5));
  EXPECT_NEAR(LightPower(triangle, 2), 5 * kPiExact * 6, 1e-4);
}

}  // namespace
}  // namespace rtb
