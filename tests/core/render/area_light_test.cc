// Light with an area must not be hidden by its own shape, however large the
// surfaces around it are.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/render/scenes.h"

namespace rtb {
namespace {

using testing::SceneBuilder;

/// A white floor, 2000 units wide so that coordinates on it are rounded
/// coarsely, seen at the origin from 2 above.
SceneBuilder WideFloor() {
  SceneBuilder b;
  const Index white = b.Add(Lambertian{Rgb(1)});
  b.Add(Quad{V3d(-1000, 0, 1000), {V3d(2000, 0, 0), V3d(0, 0, -2000)}}, white);
  b.Look(V3d(0, 2, 0), V3d(0, 0, 0));
  return b;
}

TEST(AreaLightTest, ABallOfLightOverAWideFloorIsNotInItsOwnShadow) {
  // The irradiance of a sphere above the horizon is pi L (r / d)^2 cos, and a
  // white floor shows 1 / pi of it: d = 5, cos = 3 / 5, r = 0.5. The 64
  // samples' cosines differ by up to r / d * 0.8 = 8 %; well spread they leave
  // a tenth of a percent.
  SceneBuilder b = WideFloor();
  b.AddLight(SphereLight{V3d(4, 3, 0), 0.5, Rgb(7), 64});
  EXPECT_NEAR(b.Center().x, 7 * 0.01 * 0.6, 7 * 0.01 * 0.6 * 3e-3);
}

TEST(AreaLightTest, APanelShinesThroughEverySheetOfGlass) {
  // The same samples with and without three sheets: six crossings.
  const QuadLight panel{
      V3d(-1, 9, -1), {V3d(2, 0, 0), V3d(0, 0, 2)}, Rgb(5), 16};
  SceneBuilder bare = WideFloor();
  bare.AddLight(panel);
  SceneBuilder glazed = WideFloor();
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
