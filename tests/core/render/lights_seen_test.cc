// What is seen of lights, what they block, and what reaches others.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/render/measure.h"
#include "tests/core/scene/mesh_shapes.h"

namespace rtb {
namespace {

using testing::By;
using testing::CenterEstimate;
using testing::Estimate;
using testing::kPiExact;
using testing::SceneBuilder;

constexpr const char* kBoth[] = {"whitted", "path"};

TEST(LightsSeenTest, QuadLightsFromTheirFrontAlone) {
  // e0 x e1 = +z: seen from +z it is its radiance, from behind black.
  SceneBuilder b;
  b.AddLight(
      QuadLight{V3d(-1, -1, 0), {V3d(2, 0, 0), V3d(0, 2, 0)}, Rgb(1, 2, 3), 4});
  b.SetBackground(Rgb(7));
  for (const char* integrator : kBoth) {
    b.Look(V3d(0, 0, 3), V3d(0));
    EXPECT_EQ(b.Center(By(integrator, 0)), Rgb(1, 2, 3));
    b.Look(V3d(0, 0, -3), V3d(0));
    EXPECT_EQ(b.Center(By(integrator, 0)), Rgb(0));
  }
}

TEST(LightsSeenTest, SphereLightsFromOutsideAlone) {
  SceneBuilder b;
  b.AddLight(SphereLight{V3d(0), 1, Rgb(1, 2, 3), 4});
  b.SetBackground(Rgb(7));
  for (const char* integrator : kBoth) {
    b.Look(V3d(0, 0, 3), V3d(0));
    EXPECT_EQ(b.Center(By(integrator, 0)), Rgb(1, 2, 3));
    b.Look(V3d(0), V3d(0, 0, 1));
    EXPECT_EQ(b.Center(By(integrator, 0)), Rgb(0));
  }
}

TEST(LightsSeenTest, LightsWithoutExtentAreInvisible) {
  SceneBuilder b;
  b.AddLight(PointLight{V3d(0), Rgb(9), true});
  b.AddLight(SpotLight{V3d(0, 0, -1), V3d(0, 0, 1), Rgb(9), 30, 5});
  b.AddLight(DirectionalLight{V3d(0, 0, 1), Rgb(9)});
  b.Look(V3d(0, 0, 3), V3d(0));
  for (const char* integrator : kBoth) {
    EXPECT_EQ(b.Center(By(integrator, 2)), Rgb(0));
  }
}

/// A white floor with a sun straight above it and something in between.
SceneBuilder UnderASun() {
  SceneBuilder b;
  b.Add(Plane{V3d(0), V3d(0, 1, 0)}, b.Add(Lambertian{Rgb(1)}));
  b.AddLight(DirectionalLight{V3d(0, -1, 0), Rgb(5)});
  b.Look(V3d(6, 0.4, 0), V3d(0));
  return b;
}

TEST(LightsSeenTest, LightShapesBlockOthersFromBothSides) {
  for (const char* integrator : kBoth) {
    // Both quads shine sideways past the floor's spot, or not at all.
    SceneBuilder up = UnderASun();
    up.AddLight(
        QuadLight{V3d(-1, 2, -1), {V3d(0, 0, 2), V3d(2, 0, 0)}, Rgb(0), 1});
    EXPECT_EQ(CenterEstimate(up, By(integrator, 0)).mean, 0) << integrator;
    SceneBuilder ball = UnderASun();
    ball.AddLight(SphereLight{V3d(0, 2, 0), 1, Rgb(0), 1});
    EXPECT_EQ(CenterEstimate(ball, By(integrator, 0)).mean, 0) << integrator;
    SceneBuilder beside = UnderASun();
    beside.AddLight(SphereLight{V3d(0, 2, 3), 1, Rgb(0), 1});
    EXPECT_NEAR(CenterEstimate(beside, By(integrator, 0)).mean, 5 / kPiExact,
                1e-4)
        << integrator;
  }
}

TEST(LightsSeenTest, GlassTintsShadowsUnderWhittedAndBlocksUnderPath) {
  SceneBuilder b = UnderASun();
  b.Add(Box{V3d(-1, 1, -1), V3d(1, 2, 1)}, b.Add(Dielectric{1.5, Rgb(0.5f)}));
  // Straight on, tint at each of two crossings, no Fresnel.
  EXPECT_NEAR(CenterEstimate(b, By("whitted", 0)).mean, 5 / kPiExact / 4, 1e-5);
  // A path cannot meet a sun that has no extent.
  EXPECT_EQ(CenterEstimate(b, By("path", 0, 64)).mean, 0);
}

TEST(LightsSeenTest, APathFindsAreaLightsThroughGlass) {
  // Next-event estimation is blocked; scattered rays refract to the lamp. A
  // pane's displacement does not matter under a lamp that fills the view:
  // what comes is the lamp times the pane's transmittance, (1 - F)^2 +
  // inner reflections: at index 1 all of it.
  SceneBuilder b;
  b.Add(Plane{V3d(0), V3d(0, 1, 0)}, b.Add(Lambertian{Rgb(1)}));
  b.Add(Box{V3d(-50, 1, -50), V3d(50, 1.01, 50)},
        b.Add(Dielectric{1, Rgb(0.8f)}));
  b.AddLight(
      QuadLight{V3d(-50, 2, -50), {V3d(100, 0, 0), V3d(0, 0, 100)}, Rgb(3), 4});
  b.Look(V3d(0.3, 0.5, 0), V3d(0));
  const Estimate e = CenterEstimate(b, By("path", 3, 256));
  // The lamp fills all but (2 / 50)^2 of the hemisphere, by cosine.
  EXPECT_NEAR(e.mean, 3 * 0.64, 5 * e.error + 3 * 0.64 * 4e-3);
  EXPECT_EQ(CenterEstimate(b, By("path", 2, 64)).mean, 0);
}

TEST(LightsSeenTest, EmissiveObjectsLightOthersUnderPathAlone) {
  // E = pi L (r / d)^2 of a sphere above.
  SceneBuilder b;
  b.Add(Plane{V3d(0), V3d(0, 1, 0)}, b.Add(Lambertian{Rgb(1)}));
  b.Add(Sphere{V3d(0, 4, 0), 1}, b.Add(Emissive{Rgb(16)}));
  b.Look(V3d(3, 0.5, 0), V3d(0));
  EXPECT_EQ(CenterEstimate(b, By("whitted", 2)).mean, 0);
  for (const int depth : {0, 2}) {
    const Estimate e = CenterEstimate(b, By("path", depth, 256));
    EXPECT_NEAR(e.mean, 1, 5 * e.error + 1e-4);
  }
  b.Look(V3d(0, 1, 0), V3d(0, 4, 0));
  for (const char* integrator : kBoth) {
    EXPECT_EQ(b.Center(By(integrator, 0)), Rgb(16));
  }
}

// A closed room of perfect mirrors, black without: nothing but the lamp in it
// is ever seen, and a path that never meets the lamp ends black. Were the room
// to leak, the background of 1e4 would show.
TEST(LightsSeenTest, MirrorRoomsDoNotLeak) {
  for (const bool mesh : {false, true}) {
    for (const char* integrator : kBoth) {
      SceneBuilder b;
      const Index mirror = b.Add(Mirror{Rgb(1)});
      if (mesh) {
        b.Add(Icosphere(2), mirror).scale = V3d(2);
      } else {
        b.Add(Box{V3d(-1.1, -1, -1.3), V3d(1.2, 1.05, 1)}, mirror);
      }
      b.Add(Sphere{V3d(0.3, 0.2, -0.4), 0.15}, b.Add(Emissive{Rgb(1)}));
      b.SetBackground(Rgb(1e4f));
      b.scene.camera.vfov = 90;
      b.Look(V3d(-0.5, -0.3, 0.6), V3d(0.2, 0.1, -0.5));
      const Fragments f = b.Render(PixelPlan(90, 60), By(integrator, 64, 2));
      int seen = 0;
      for (const Rgb& v : f.values) {
        // Roulette lifts what it keeps of a path; one leak gives 5000.
        EXPECT_LT(v.x, 60) << integrator;
        seen += v.x > 0;
      }
      // 64 bounces in a small room: most rays find the lamp.
      EXPECT_GT(seen, 1500) << integrator << mesh;
    }
  }
}

}  // namespace
}  // namespace rtb
