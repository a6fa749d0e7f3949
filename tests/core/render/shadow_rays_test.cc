// Shadow rays end where they should, whatever the size of what they leave.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/render/measure.h"

namespace rtb {
namespace {

using testing::By;
using testing::CenterEstimate;
using testing::Estimate;
using testing::kPiExact;
using testing::SceneBuilder;

/// A white quad of half width `r` around the origin, seen from the side.
SceneBuilder Floor(double r) {
  SceneBuilder b;
  b.Add(Quad{V3d(-r, 0, -r), {V3d(0, 0, 2 * r), V3d(2 * r, 0, 0)}},
        b.Add(Lambertian{Rgb(1)}));
  b.Look(V3d(3, 2, 0), V3d(0));
  return b;
}

// A new ray starts off its surface by an error bound that grows with the
// surface's extent: 1 cm on a floor of 10 km. An area light's own shape must
// not block what starts so much nearer to it.
TEST(ShadowRaysTest, AreaLightsDoNotShadowThemselvesOverLargeFloors) {
  for (const double r : {10.0, 1e3, 1e4, 1e5}) {
    for (const char* integrator : {"whitted", "path"}) {
      // E = pi L (radius / distance)^2 of a sphere right above.
      SceneBuilder ball = Floor(r);
      ball.AddLight(SphereLight{V3d(0, 4, 0), 1, Rgb(16), 16});
      EXPECT_NEAR(CenterEstimate(ball, By(integrator, 0, 16)).mean, 1, 0.01)
          << integrator << " " << r;
      // A small quad: E = L A cos cos / d^2, within (size / d)^2.
      SceneBuilder panel = Floor(r);
      panel.AddLight(QuadLight{V3d(-0.05, 4, -0.05),
                               {V3d(0.1, 0, 0), V3d(0, 0, 0.1)},
                               Rgb(1600),
                               4});
      EXPECT_NEAR(CenterEstimate(panel, By(integrator, 0, 16)).mean,
                  1 / kPiExact, 1e-3)
          << integrator << " " << r;
    }
  }
}

// A lamp beside a sun that falls on a large scene has next to no share of the
// power, yet is what lights the place.
TEST(ShadowRaysTest, NoLightIsTooWeakToBeChosen) {
  SceneBuilder b = Floor(1e5);
  b.AddLight(DirectionalLight{V3d(0, -1, 1e-3), Rgb(1)});
  b.AddLight(PointLight{V3d(0, 1, 0), Rgb(1), true});
  // A board between the sun and the place, above the lamp.
  b.Add(Quad{V3d(-1, 2, -1), {V3d(2, 0, 0), V3d(0, 0, 2)}}, 0);
  b.Look(V3d(2, 0.5, 0), V3d(0));
  const Estimate e = CenterEstimate(b, By("path", 0, 64));
  EXPECT_NEAR(e.mean, 1 / kPiExact, 5 * e.error + 1e-4);
  EXPECT_LT(e.error, 0.05);
}

TEST(ShadowRaysTest, APanelShinesThroughEverySheetOfGlass) {
  // The same samples with and without three sheets: six crossings.
  const QuadLight panel{
      V3d(-1, 9, -1), {V3d(2, 0, 0), V3d(0, 0, 2)}, Rgb(5), 16};
  SceneBuilder bare = Floor(1000);
  bare.AddLight(panel);
  SceneBuilder glazed = Floor(1000);
  glazed.AddLight(panel);
  const Index glass = glazed.Add(Dielectric{1.5, Rgb(0.9f)});
  for (const double y : {3.0, 5.0, 7.0}) {
    glazed.Add(Box{V3d(-500, y, -500), V3d(500, y + 0.5, 500)}, glass);
  }
  const double without = bare.Center().x;
  EXPECT_GT(without, 0);
  EXPECT_NEAR(glazed.Center().x, without * std::pow(0.9, 6), 1e-5 * without);
}

}  // namespace
}  // namespace rtb
