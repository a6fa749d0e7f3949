/// @file
/// Spot and area lights as POV-Ray draws them, against their formulas.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/reference/pov_pixels.h"

namespace rtb {
namespace {

TEST(PovRayTest, HardSpotAndPhongHighlight) {
  SKIP_WITHOUT_POVRAY();
  Scene scene = MakeScene();
  AddObject(&scene, Plane{V3d(0, -1, 0), V3d(0, 1, 0)},
            AddMaterial(&scene, Phong{Rgb(0.3f), Rgb(0.5f), 20, Rgb(0)}));
  const V3d light(0, 1, -2);
  AddLight(&scene, SpotLight{light, V3d(0, -1, 0), Rgb(5), 30, 0});
  ExpectEverywhere(Pixels(scene, 96, 64), kHalf, [&](const V3d& d) {
    if (d.y >= -0.1) return kNoValue;
    const V3d to_light = light - d / -d.y;
    const double angle = std::acos(2 / to_light.length()) * 180 / kPi;
    if (std::abs(angle - 30) < 0.01) return kNoValue;
    if (angle > 30) return V3d(0);
    const double along = V3d(d.x, -d.y, d.z).dot(to_light.normalized());
    const double e = 5 / to_light.length2();
    return V3d(0.3 * e * to_light.normalized().y +
               0.5 * std::pow(std::max(0.0, along), 20) * e) /
           kPi;
  });
}

TEST(PovRayTest, SphereLightIsAsBrightAsItsSolidAngle) {
  SKIP_WITHOUT_POVRAY();
  // E = pi L (r/d)^2 cos for a sphere above the horizon: with 178 emitters on
  // its surface within 1 %. The camera sees the sphere itself too.
  Scene scene = MakeScene();
  AddObject(&scene, Plane{V3d(0, -1, 0), V3d(0, 1, 0)},
            AddMaterial(&scene, Lambertian{Rgb(1)}));
  const V3d center(0, 2, -4);
  AddLight(&scene, SphereLight{center, 0.5, Rgb(7), 16});
  ExpectEverywhere(Pixels(scene, 48, 32), 0.01, [&](const V3d& d) {
    if (d.dot(center.normalized()) >
        std::cos(std::asin(0.45 / center.length())))
      return V3d(7);
    if (d.y >= -0.2) return kNoValue;
    return V3d(7 * 0.25 * kPi) * UnderPointLight(d / -d.y, center);
  });
}

/// Lambert's formula: irradiance of a polygon of radiance 1 at the origin of
/// a horizontal plane, 1/2 sum of the edges' angles times the y of their
/// normals. Arvo, "Analytic Methods for Simulated Light Transport", 1995.
double PolygonIrradiance(const std::vector<V3d>& corners) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const V3d a = corners[i].normalized();
    const V3d b = corners[(i + 1) % corners.size()].normalized();
    sum += std::acos(a.dot(b)) * a.cross(b).normalized().y;
  }
  return std::abs(sum) / 2;
}

TEST(PovRayTest, QuadLightMatchesLambertsFormula) {
  SKIP_WITHOUT_POVRAY();
  Scene scene = MakeScene();
  AddObject(&scene, Plane{V3d(0, -1, 0), V3d(0, 1, 0)},
            AddMaterial(&scene, Lambertian{Rgb(1)}));
  // (2, 0, 0) x (0, 0, 1) = (0, -2, 0): it shines down.
  const QuadLight panel{
      V3d(-1, 1, -4), {V3d(2, 0, 0), V3d(0, 0, 1)}, Rgb(3), 16};
  AddLight(&scene, panel);
  ExpectEverywhere(Pixels(scene, 48, 32), 0.01, [&](const V3d& d) {
    if (d.y > 0.5) return kNoValue;
    const V3d p = d / std::abs(d.y);
    if (d.y > 0) {  // the panel from below, or the black beyond
      const bool hit = std::abs(p.x) < 0.95 && p.z < -3.05 && p.z > -3.95;
      const bool near = std::abs(p.x) < 1.05 && p.z < -2.95 && p.z > -4.05;
      return hit ? V3d(3) : near ? kNoValue : V3d(0);
    }
    if (d.y > -0.2) return kNoValue;
    const V3d c = panel.corner - p;
    const auto& [u, v] = panel.edges;
    return V3d(3 * PolygonIrradiance({c, c + u, c + u + v, c + v}) / kPi);
  });
}

/// A wall lit by a panel that a bar hides in part, seen through one pixel.
Scene PenumbraScene() {
  Scene scene = MakeScene();
  scene.camera.vfov = 1;
  AddObject(&scene, Plane{V3d(0, 0, -10), V3d(0, 0, 1)},
            AddMaterial(&scene, Lambertian{Rgb(1)}));
  AddObject(&scene, Box{V3d(2, -9, -6), V3d(2.4, 9, -5.6)});
  AddLight(&scene,
           QuadLight{V3d(4, -1, -3), {V3d(0, 2, 0), V3d(1, 0, -1)}, Rgb(9), 1});
  return scene;
}

TEST(PovRayTest, EveryPassLightsFromElsewhere) {
  SKIP_WITHOUT_POVRAY();
  // Five emitters cannot tell how much of the panel the bar hides, but 16
  // passes of five others each can: better than a thirtieth.
  const Scene scene = PenumbraScene();
  const float truth = Pixels(scene, 1, 1, 1, 4096).at(0, 0).x;
  const float one_pass = Pixels(scene, 1, 1, 1, 5).at(0, 0).x;
  const float passes = Pixels(scene, 1, 1, 16, 5).at(0, 0).x;
  EXPECT_GT(std::abs(one_pass / truth - 1), 0.03f);
  EXPECT_LT(std::abs(passes / truth - 1), 0.03f);
}

TEST(PovRayTest, PenumbraIsASmoothstepOfTheAngle) {
  SKIP_WITHOUT_POVRAY();
  Scene scene = MakeScene();
  AddObject(&scene, Plane{V3d(0, -1, 0), V3d(0, 1, 0)},
            AddMaterial(&scene, Lambertian{Rgb(1)}));
  const V3d light(0, 1, -2);
  AddLight(&scene, SpotLight{light, V3d(0, -1, 0), Rgb(5), 20, 30});
  ExpectEverywhere(Pixels(scene, 96, 64), kHalf, [&](const V3d& d) {
    if (d.y >= -0.1) return kNoValue;
    const V3d p = d / -d.y;
    const double angle = std::acos(2 / (light - p).length()) * 180 / kPi;
    const double s = std::clamp((50 - angle) / 30, 0.0, 1.0);
    // Near 0 halves are coarser than their relative error.
    if (s > 0 && s < 0.02) return kNoValue;
    return V3d(5 * s * s * (3 - 2 * s) * UnderPointLight(p, light));
  });
}

TEST(PovRayTest, TheBackOfAQuadLightIsBlackAndBlocks) {
  SKIP_WITHOUT_POVRAY();
  // Seen from behind before white: black.
  Scene scene = MakeScene();
  scene.background.kind = ConstantBackground{Rgb(1)};
  AddLight(
      &scene,
      QuadLight{V3d(-9, -9, -3), {V3d(0, 18, 0), V3d(18, 0, 0)}, Rgb(3), 1});
  EXPECT_EQ(Pixels(scene, 8, 8).at(4, 4), Rgb(0));
}

}  // namespace
}  // namespace rtb
