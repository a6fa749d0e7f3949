#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/shading/light_tools.h"

namespace rtb {
namespace {

const V3f kUp(0, 1, 0);

/// Irradiance of a sphere of radiance 1 and angular radius `rim` (sine) whose
/// center is `tilt` radians off the normal, by rings around the normal: the
/// ring at angle t lies in the sphere over an azimuth of 2 phi, with
/// cos(rim) = cos t cos(tilt) + sin t sin(tilt) cos phi.
double RingQuadrature(double rim, double tilt) {
  constexpr int kRings = 20000;
  const double cos_rim = std::sqrt(1 - rim * rim);
  double sum = 0;
  for (int i = 0; i < kRings; ++i) {
    const double t = (i + 0.5) * kPiExact / 2 / kRings;
    const double c = (cos_rim - std::cos(t) * std::cos(tilt)) /
                     (std::sin(t) * std::sin(tilt));
    sum += std::cos(t) * std::sin(t) * 2 * std::acos(std::clamp(c, -1.0, 1.0));
  }
  return sum * kPiExact / 2 / kRings;
}

// E = pi L (r / d)^2 cos while the whole sphere is above the horizon.
TEST(SphereLightTest, IrradianceOfAFullyVisibleSphere) {
  const LightData sphere = MakeSphere(V3d(3, 4, 0), 2, Rgb(7));
  EXPECT_NEAR(Irradiance(sphere, V3f(0), kUp, 64),
              kPiExact * 7 * (4 / 25.0) * 0.8, 1e-3);
  const LightData above = MakeSphere(V3d(0, 10, 0), 9.9, Rgb(1));
  EXPECT_NEAR(Irradiance(above, V3f(0), kUp, 64), kPiExact * 0.9801, 1e-3);
}

TEST(SphereLightTest, IrradianceOfASphereThatSets) {
  // The rings agree with the closed form where it holds.
  ASSERT_NEAR(RingQuadrature(0.4, 0.5), kPiExact * 0.16 * std::cos(0.5), 1e-6);
  for (const double tilt : {1.3, kPiExact / 2, 1.8}) {
    const V3d center(5 * std::sin(tilt), 5 * std::cos(tilt), 0);
    const LightData sphere = MakeSphere(center, 2, Rgb(1));
    EXPECT_NEAR(Irradiance(sphere, V3f(0), kUp, 200), RingQuadrature(0.4, tilt),
                2e-4)
        << tilt;
  }
}

// Seen as small as the float can tell and from just above the surface, where
// it fills half of all directions.
TEST(SphereLightTest, PreciseFromAnyDistance) {
  for (const double distance : {1.0001, 1.5, 1e2, 1e5, 1e8, 1e15}) {
    const LightData sphere = MakeSphere(V3d(0, distance, 0), 1, Rgb(1));
    const double expected = kPiExact / distance / distance;
    EXPECT_NEAR(Irradiance(sphere, V3f(0), kUp, 64), expected, 1e-3 * expected)
        << distance;
    const LightSample s = SampleLight(sphere, V3f(0), V2f(0.3f, 0.6f));
    EXPECT_NEAR(s.direction.length(), 1, 1e-6);
    EXPECT_LE(s.distance, distance);
    EXPECT_GE(s.distance, distance - 1 - 1e-7 * distance);
  }
}

TEST(SphereLightTest, SamplesLieOnTheSphere) {
  const V3f center(3, 4, -1);
  const LightData sphere = MakeSphere(V3d(center), 2, Rgb(7));
  MeanOverSquare(16, [&](const V2f& u) {
    const LightSample s = SampleLight(sphere, V3f(0.5f), u);
    const V3f point = V3f(0.5f) + s.direction * s.distance;
    EXPECT_NEAR((point - center).length(), 2, 1e-5);
    // On the near side.
    EXPECT_LE(s.direction.dot(point - center), 1e-3);
    return 0;
  });
}

TEST(SphereLightTest, BlackInsideFiniteOnTheSurface) {
  const LightData sphere = MakeSphere(V3d(0), 1, Rgb(5));
  for (const float y : {0.0f, 0.5f, 0.999f}) {
    EXPECT_EQ(SampleLight(sphere, V3f(0, y, 0), V2f(0.5f)).irradiance, Rgb(0));
    EXPECT_EQ(LightPdf(sphere, V3f(0, y, 0), kUp, 1), 0);
  }
  // On the surface: a hemisphere, radiance * 2 pi, at no distance at all.
  const LightSample s = SampleLight(sphere, kUp, V2f(0.5f));
  EXPECT_NEAR(s.irradiance.x, 5 * 2 * kPiExact, 1e-4);
  EXPECT_NEAR(s.pdf, 1 / (2 * kPiExact), 1e-7);
  EXPECT_GE(s.distance, 0);
  EXPECT_EQ(EmittedRadiance(sphere, -kUp, kUp), Rgb(5));
  EXPECT_EQ(EmittedRadiance(sphere, kUp, kUp), Rgb(0));
}

}  // namespace
}  // namespace rtb
