#include "core/render/whitted.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/core/render/scenes.h"

namespace rtb {
namespace {

using testing::SceneBuilder;

constexpr double kPiExact = std::numbers::pi;

RenderOptions Depth(int max_depth) {
  RenderOptions options;
  options.max_depth = max_depth;
  return options;
}

void ExpectNear(const Rgb& actual, const V3d& expected, double relative) {
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(actual[c], expected[c],
                relative * std::max(1e-3, std::abs(expected[c])))
        << "channel " << c;
  }
}

TEST(WhittedTest, PointLightOnAPlane) {
  // Radiance = albedo / pi * I cos / d^2 with the light 3 up and 4 aside:
  // d = 5, cos = 3/5.
  SceneBuilder b;
  const Index m = b.Add(Lambertian{Rgb(0.2f, 0.5f, 0.8f)});
  b.Add(Plane{V3d(0), V3d(0, 1, 0)}, m);
  b.AddLight(PointLight{V3d(4, 3, 0), Rgb(10, 20, 30), true});
  b.Look(V3d(0, 2, 0), V3d(0, 0, 0));
  const double factor = 0.6 / 25 / kPiExact;
  ExpectNear(b.Center(), V3d(0.2 * 10, 0.5 * 20, 0.8 * 30) * factor, 1e-5);
}

TEST(WhittedTest, PointLightWithoutFalloffAndDirectionalLight) {
  SceneBuilder b;
  const Index m = b.Add(Lambertian{Rgb(0.5f)});
  b.Add(Plane{V3d(0), V3d(0, 1, 0)}, m);
  b.AddLight(PointLight{V3d(4, 3, 0), Rgb(1, 2, 3), false});
  b.AddLight(DirectionalLight{V3d(0, -2, 0), Rgb(7)});
  b.Look(V3d(0, 2, 0), V3d(0, 0, 0));
  ExpectNear(b.Center(), (V3d(1, 2, 3) * 0.6 + V3d(7)) * (0.5 / kPiExact),
             1e-5);
}

TEST(WhittedTest, LambertianIsTwoSidedAndLightsBehindItDoNotCount) {
  SceneBuilder b;
  const Index m = b.Add(Lambertian{Rgb(1)});
  // Clockwise seen from the camera: its back.
  b.Add(Triangle{{V3d(-5, -5, -2), V3d(0, 5, -2), V3d(5, -5, -2)}}, m);
  b.AddLight(DirectionalLight{V3d(0, 0, -1), Rgb(3)});
  b.AddLight(DirectionalLight{V3d(0, 0, 1), Rgb(100)});
  ExpectNear(b.Center(), V3d(3 / kPiExact), 1e-5);
}

TEST(WhittedTest, OpaqueObjectsCastShadowsLightsBeyondDoNot) {
  for (const double blocker_height : {2.0, 9.0}) {
    SceneBuilder b;
    const Index m = b.Add(Lambertian{Rgb(1)});
    b.Add(Plane{V3d(0), V3d(0, 1, 0)}, m);
    b.Add(Sphere{V3d(0, blocker_height, 0), 0.5}, m);
    b.AddLight(PointLight{V3d(0, 5, 0), Rgb(25), true});
    b.Look(V3d(3, 3, 0), V3d(0, 0, 0));
    ExpectNear(b.Center(), V3d(blocker_height < 5 ? 0 : 1 / kPiExact), 1e-5);
  }
}

TEST(WhittedTest, DielectricTintsShadowsAtEachCrossing) {
  SceneBuilder b;
  const Index floor = b.Add(Lambertian{Rgb(1)});
  const Index glass = b.Add(Dielectric{1.5, Rgb(0.5f, 0.8f, 1)});
  b.Add(Plane{V3d(0), V3d(0, 1, 0)}, floor);
  b.Add(Box{V3d(-1, 1, -1), V3d(1, 2, 1)}, glass);
  b.AddLight(DirectionalLight{V3d(0, -1, 0), Rgb(1)});
  b.Look(V3d(5, 0.5, 0), V3d(0, 0, 0));
  ExpectNear(b.Center(), V3d(0.25, 0.64, 1) / kPiExact, 1e-5);
}

TEST(WhittedTest, AmbientIsAlbedoTimesAmbient) {
  SceneBuilder b;
  const Index m = b.Add(Lambertian{Rgb(0.5f, 0.25f, 1)});
  b.Add(Plane{V3d(0, 0, -1), V3d(0, 0, 1)}, m);
  b.scene.settings.ambient = Rgb(0.1f, 0.2f, 0.3f);
  ExpectNear(b.Center(), V3d(0.05, 0.05, 0.3), 1e-6);
}

TEST(WhittedTest, ObjectsWithoutMaterialAreHalfGray) {
  SceneBuilder b;
  b.Add(Plane{V3d(0, 0, -1), V3d(0, 0, 1)}, kNone);
  b.AddLight(
      DirectionalLight{V3d(0, 0, -1), Rgb(static_cast<float>(kPiExact))});
  ExpectNear(b.Center(), V3d(0.5), 1e-6);
}

TEST(WhittedTest, MirrorReflectsTheSameAtEveryAngle) {
  for (const double slope : {0.0, 1.0, 20.0}) {
    SceneBuilder b;
    const Index m = b.Add(Mirror{Rgb(0.9f, 0.5f, 0.1f)});
    b.Add(Plane{V3d(0, 0, -1), V3d(slope, 0, 1)}, m);
    b.SetBackground(Rgb(2));
    ExpectNear(b.Center(), V3d(1.8, 1, 0.2), 1e-5);
  }
}

TEST(WhittedTest, MetalFollowsSchlick) {
  SceneBuilder b;
  const Index m = b.Add(Metal{Rgb(0.2f, 0.5f, 0.8f), 0});
  b.Add(Plane{V3d(0, 0, -1), V3d(std::sqrt(3), 0, 1)}, m);  // cos = 1/2
  b.SetBackground(Rgb(1));
  const V3d f0(0.2, 0.5, 0.8);
  ExpectNear(b.Center(), f0 + (V3d(1) - f0) / 32, 1e-5);
}

TEST(WhittedTest, FacingMirrorsAttenuateUntilTheDepthLimit) {
  // The ray bounces between two mirrors until it meets the lamp that closes
  // the corridor: here it never does, so any depth is black. With a lamp in
  // place of the far mirror one bounce brings its light.
  SceneBuilder b;
  const Index mirror = b.Add(Mirror{Rgb(0.5f)});
  const Index lamp = b.Add(Emissive{Rgb(8)});
  b.Add(Plane{V3d(0, 0, -1), V3d(0, 0, 1)}, mirror);
  b.Add(Plane{V3d(0, 0, 1), V3d(0, 0, -1)}, mirror);
  b.SetBackground(Rgb(100));
  EXPECT_EQ(b.Center(Depth(64)), Rgb(0));
  b.scene.objects[1].material = lamp;
  EXPECT_EQ(b.Center(Depth(0)), Rgb(0));  // past the limit is black
  ExpectNear(b.Center(Depth(1)), V3d(4), 1e-6);
}

TEST(WhittedTest, RaysOfLittleWeightAreNotFollowed) {
  // The second bounce of the corner below has the weight 1/4.
  SceneBuilder b;
  const Index mirror = b.Add(Mirror{Rgb(0.5f)});
  b.Add(Quad{V3d(-3, -3, -2), {V3d(6, 0, 0), V3d(0, 0, -6)}}, mirror);
  b.Add(Quad{V3d(-3, -3, -8), {V3d(6, 0, 0), V3d(0, 6, 0)}}, mirror);
  b.Look(V3d(0, 0, 0), V3d(0, -3, -6));
  b.SetBackground(Rgb(1));
  RenderOptions options = Depth(2);
  options.least_weight = 0.24f;
  ExpectNear(b.Center(options), V3d(0.25), 1e-5);
  options.least_weight = 0.26f;
  EXPECT_EQ(b.Center(options), Rgb(0));
}

TEST(WhittedTest, EachBounceCountsOne) {
  // Camera in a mirror corner: two bounces return the ray to the background.
  SceneBuilder b;
  const Index mirror = b.Add(Mirror{Rgb(0.5f)});
  b.Add(Quad{V3d(-3, -3, -2), {V3d(6, 0, 0), V3d(0, 0, -6)}}, mirror);
  b.Add(Quad{V3d(-3, -3, -8), {V3d(6, 0, 0), V3d(0, 6, 0)}}, mirror);
  b.Look(V3d(0, 0, 0), V3d(0, -3, -6));
  b.SetBackground(Rgb(1));
  EXPECT_EQ(b.Center(Depth(1)), Rgb(0));
  ExpectNear(b.Center(Depth(2)), V3d(0.25), 1e-5);
}

TEST(WhittedTest, GlassSlabSumsTheSeriesUpToItsDepth) {
  // White surroundings: the eye ray splits into reflection and transmission;
  // what is missing after D bounces inside is the part still inside.
  // Normal incidence, F = 0.04: radiance = F + (1-F)^2 (1 + F + F^2 + ...),
  // D bounces = one entry and D-1 further hits, each leaving one exit.
  SceneBuilder b;
  const Index glass = b.Add(Dielectric{1.5, Rgb(1)});
  b.Add(Box{V3d(-9, -9, -3), V3d(9, 9, -2)}, glass);
  b.SetBackground(Rgb(1));
  const double f = 0.04;
  for (const int depth : {1, 2, 3, 6}) {
    double expected = f, inside = 1 - f;
    for (int hit = 2; hit <= depth; ++hit) {
      expected += inside * (1 - f);
      inside *= f;
    }
    ExpectNear(b.Center(Depth(depth)), V3d(expected), 2e-6);
  }
}

TEST(WhittedTest, GlassSphereInAWhiteFurnaceIsWhite) {
  SceneBuilder b;
  const Index glass = b.Add(Dielectric{1.5, Rgb(1)});
  b.Add(Sphere{V3d(0.3, 0.2, -3), 1}, glass);
  b.SetBackground(Rgb(1));
  const Fragments f = b.Render(PixelPlan(31, 31), Depth(16));
  for (const Rgb& v : f.values) {
    EXPECT_LE(v.x, 1 + 1e-5f);
    EXPECT_GE(v.x, 0.99f);  // grazing rays keep the longest tail inside
  }
}

TEST(WhittedTest, TintMultipliesTransmissionNotReflection) {
  SceneBuilder b;
  const Index glass = b.Add(Dielectric{1.5, Rgb(0.5f, 1, 1)});
  b.Add(Box{V3d(-9, -9, -3), V3d(9, 9, -2)}, glass);
  b.SetBackground(Rgb(1));
  // Depth 2: F + tint^2 (1-F)^2.
  const double f = 0.04, t = (1 - f) * (1 - f);
  ExpectNear(b.Center(Depth(2)), V3d(f + 0.25 * t, f + t, f + t), 2e-6);
}

TEST(WhittedTest, SlabDisplacesTheRayAsSnellSays) {
  // Thickness 1, 45 degrees, n = 1.5: the ray leaves the far side at
  // 1 * tan(asin(sin 45 / 1.5)) and goes on in parallel. It must hit a lamp
  // of radius 0.001 laid out for that.
  SceneBuilder b;
  const Index glass = b.Add(Dielectric{1.5, Rgb(1)});
  const Index lamp = b.Add(Emissive{Rgb(1)});
  b.Add(Box{V3d(-9, -9, -3), V3d(9, 9, -2)}, glass);
  b.Look(V3d(0), V3d(1, 0, -1));
  const double sin_t = std::sqrt(0.5) / 1.5;
  const double x = 2 + sin_t / std::sqrt(1 - sin_t * sin_t) + 1;
  b.Add(Disk{V3d(x, 0, -4), V3d(0, 0, 1), 0.001}, lamp);
  EXPECT_GT(b.Center(Depth(2)).x, 0.8f);
  b.scene.objects.back().position = V3d(0.003, 0, 0);
  EXPECT_EQ(b.Center(Depth(2)).x, 0);
}

TEST(WhittedTest, TotalInternalReflectionKeepsAllLight) {
  // From inside glass at 60 degrees onto a face: only the mirror direction.
  SceneBuilder b;
  const Index glass = b.Add(Dielectric{1.5, Rgb(0)});  // nothing gets out
  const Index lamp = b.Add(Emissive{Rgb(1)});
  b.Add(Plane{V3d(0, 1, 0), V3d(0, 1, 0)}, glass);
  b.Add(Plane{V3d(0, -1, 0), V3d(0, 1, 0)}, lamp);
  b.Look(V3d(0), V3d(std::sqrt(3), 1, 0));
  ExpectNear(b.Center(), V3d(1), 1e-6);
}

TEST(WhittedTest, GradientBackgroundFollowsY) {
  SceneBuilder b;
  b.scene.background.kind = GradientBackground{Rgb(1, 0, 0), Rgb(0, 0, 1)};
  b.Look(V3d(0), V3d(0, 3, -4));  // y = 0.6, share 0.8
  ExpectNear(b.Center(), V3d(0.2, 0, 0.8), 1e-6);
}

TEST(WhittedTest, CheckerLivesInObjectSpace) {
  // Cells of 1 on a quad turned by 90 degrees about z and scaled by 2: world
  // (0.5, 1, -3) is object (0.5, -0.25): odd.
  SceneBuilder b;
  const Index m = b.Add(Lambertian{}, CheckerTexture{Rgb(1), Rgb(0.25f), 1});
  Object& quad = b.Add(Quad{V3d(-3, -3, 0), {V3d(6, 0, 0), V3d(0, 6, 0)}}, m);
  quad.position = V3d(0, 0, -3);
  quad.rotate = V3d(0, 0, 90);
  quad.scale = V3d(2, 2, 2);
  b.scene.settings.ambient = Rgb(1);
  b.Look(V3d(0.5, 1, 0), V3d(0.5, 1, -3));
  ExpectNear(b.Center(), V3d(0.25), 1e-6);
  b.Look(V3d(-0.5, 1, 0), V3d(-0.5, 1, -3));  // object (0.5, 0.25): even
  ExpectNear(b.Center(), V3d(1), 1e-6);
}

TEST(WhittedTest, ALightOnTheSurfaceGivesNoInfinity) {
  SceneBuilder b;
  const Index m = b.Add(Lambertian{Rgb(1)});
  b.Add(Plane{V3d(0, 0, -1), V3d(0, 0, 1)}, m);
  b.AddLight(PointLight{V3d(0, 0, -1), Rgb(1e30f), true});
  b.AddLight(PointLight{V3d(0, 0, -1 + 1e-6), Rgb(1e38f), true});
  for (const Rgb& v : b.Render(PixelPlan(7, 7)).values) {
    for (int c = 0; c < 3; ++c) EXPECT_TRUE(std::isfinite(v[c]));
  }
}

}  // namespace
}  // namespace rtb
