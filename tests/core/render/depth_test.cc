// What the depth limit lets through, by both integrators.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/render/measure.h"
#include "tests/core/scene/mesh_shapes.h"

namespace rtb {
namespace {

using testing::By;
using testing::CenterEstimate;
using testing::CountOff;
using testing::Estimate;
using testing::GreenOf;
using testing::kPiExact;
using testing::Runs;
using testing::SceneBuilder;

// Inside a Lambertian sphere of radius R a point light at the center gives
// the radiance L = albedo / pi * I / R^2 everywhere, and each bounce gives
// `albedo` times what the one before gave: N bounces give
// L (1 + albedo + ... + albedo^N), in every single path until roulette sets in.
TEST(DepthTest, IntegratingSphereSumsItsSeries) {
  for (const double albedo : {0.5, 0.9}) {
    SceneBuilder b;
    b.Add(Sphere{V3d(0), 2},
          b.Add(Lambertian{Rgb(static_cast<float>(albedo))}));
    b.AddLight(PointLight{V3d(0), Rgb(4), true});
    b.Look(V3d(0.3, 0.2, 0.1), V3d(1, 0.5, -0.4));
    double sum = 0, term = albedo / kPiExact;
    for (int depth = 0; depth <= 12; ++depth) {
      sum += term;
      term *= albedo;
      const Estimate e = CenterEstimate(b, By("path", depth, 256));
      // Roulette keeps a whole number of the 256 rays, the same for each seed.
      const double kept = depth > 3 ? term / albedo / 256 : 0;
      EXPECT_NEAR(e.mean, sum, 4 * e.error + 2e-5 * sum + kept) << depth;
      if (depth <= 3) {
        EXPECT_LT(e.error, 1e-5) << depth;
      }
    }
  }
}

/// A lamp of radius 1/2 at the center of a Lambertian sphere of radius 2.
enum class LampKind { kLight, kSphere, kSqueezed, kMesh };

SceneBuilder LampInASphere(LampKind kind) {
  SceneBuilder b;
  b.Add(Sphere{V3d(0), 2}, b.Add(Lambertian{Rgb(0.8f)}));
  if (kind == LampKind::kLight) {
    b.AddLight(SphereLight{V3d(0), 0.5, Rgb(3), 16});
  } else {
    const Index lamp = b.Add(Emissive{Rgb(3)});
    Object& object = kind == LampKind::kMesh ? b.Add(Icosphere(3), lamp)
                                             : b.Add(Sphere{V3d(0), 1}, lamp);
    object.scale = V3d(0.5);
    // Next to a sphere, but no longer one that can be sampled.
    if (kind == LampKind::kSqueezed) object.scale.x = 0.5001;
  }
  b.Look(V3d(1, 0.9, 0.3), V3d(1.2, 1.5, -0.4));
  return b;
}

// The lamp fills s = (r / R)^2 = 1/16 of what each point of the wall sees,
// weighted by the cosine; it reflects nothing. So direct light is albedo Le s
// and each bounce multiplies by albedo (1 - s), whatever technique finds the
// lamp: a light, an emissive sphere or mesh, or (squeezed) chance alone.
TEST(DepthTest, LampsOfAllKindsCountAlikeAtEveryDepth) {
  for (const LampKind kind : {LampKind::kLight, LampKind::kSphere,
                              LampKind::kSqueezed, LampKind::kMesh}) {
    const SceneBuilder b = LampInASphere(kind);
    // A convex mesh sends pi Le area to the wall, somewhat unevenly.
    const double area =
        kind == LampKind::kMesh ? AreaOf(Icosphere(3)) : 4 * kPiExact;
    const double share = area / (4 * kPiExact) / 16;
    const double slack = kind == LampKind::kMesh ? 2e-3 : 1e-4;
    double sum = 0, term = 0.8 * 3 * share;
    for (int depth = 0; depth <= 5; ++depth) {
      sum += term;
      term *= 0.8 * (1 - share);
      const Estimate e = CenterEstimate(b, By("path", depth, 256), 32);
      EXPECT_NEAR(e.mean, sum, 5 * e.error + slack * sum)
          << static_cast<int>(kind) << " " << depth;
      EXPECT_LT(e.error, 0.02 * sum);
    }
  }
}

// Within a closed emissive enclosure all that shines on a convex body is e:
// it shows albedo e, be the walls quads that are sampled or a sphere, found
// from within by scattered rays alone.
TEST(DepthTest, EmissiveEnclosuresLightWhatIsInThem) {
  for (const bool round : {false, true}) {
    for (const int depth : {0, 1, 3}) {
      SceneBuilder b;
      b.Add(Sphere{V3d(0, 0, -3), 1}, b.Add(Lambertian{Rgb(0.7f)}));
      const Index walls = b.Add(Emissive{Rgb(2)});
      if (round) {
        b.Add(Sphere{V3d(0), 6}, walls);
      } else {
        b.Add(Box{V3d(-5), V3d(6)}, walls);
      }
      const Estimate e = CenterEstimate(b, By("path", depth, 256), 32);
      EXPECT_NEAR(e.mean, 1.4, 5 * e.error + 1e-5) << round << " " << depth;
      EXPECT_LT(e.error, 0.03);
    }
  }
}

// Between mirrors x = -1 and x = 1 a ray along (1, 0, -1) from the middle
// reaches z = -(2 n - 1) at its n-th mirror. A lamp across the corridor at
// z = -2 n is seen over exactly n bounces: reflectance^n at that depth and
// beyond, black before.
TEST(DepthTest, ParallelMirrorsAttenuateOnceABounce) {
  for (const char* integrator : {"whitted", "path"}) {
    for (const int bounces : {1, 2, 7, 64}) {
      SceneBuilder b;
      const Index mirror = b.Add(Mirror{Rgb(0.95f)});
      b.Add(Plane{V3d(-1, 0, 0), V3d(1, 0, 0)}, mirror);
      b.Add(Plane{V3d(1, 0, 0), V3d(-1, 0, 0)}, mirror);
      b.Add(Plane{V3d(0, 0, -2.0 * bounces), V3d(0, 0, 1)},
            b.Add(Emissive{Rgb(10)}));
      b.SetBackground(Rgb(1000));
      b.Look(V3d(0), V3d(1, 0, -1));
      EXPECT_EQ(CenterEstimate(b, By(integrator, bounces - 1, 16)).mean, 0)
          << integrator << " " << bounces;
      const Estimate e = CenterEstimate(b, By(integrator, bounces, 256));
      const double expected = 10 * std::pow(0.95, bounces);
      EXPECT_NEAR(e.mean, expected, 5 * e.error + 1e-4 * expected)
          << integrator << " " << bounces;
    }
  }
}

/// Lambertian bodies, a blocker and one light.
SceneBuilder DirectScene(const decltype(Light::kind)& light) {
  SceneBuilder b;
  const Index clay = b.Add(Lambertian{Rgb(0.7f, 0.5f, 0.3f)});
  const Index tiles =
      b.Add(Lambertian{}, CheckerTexture{Rgb(0.8f), Rgb(0.2f), 0.7});
  b.Add(Plane{V3d(0, -1, 0), V3d(0, 1, 0)}, tiles);
  b.Add(Sphere{V3d(-0.6, 0, -1), 1}, clay);
  b.Add(Box{V3d(0.6, -1, -0.5), V3d(1.2, 0.4, 0.5)}, clay).rotate =
      V3d(0, 30, 0);
  Object& mesh = b.Add(SmoothIcosphere(2), clay);
  mesh.position = V3d(0.3, 0.9, 0.4);
  mesh.scale = V3d(0.3, 0.4, 0.3);
  b.AddLight(light);
  b.scene.camera.vfov = 45;
  b.Look(V3d(1, 1.5, 5), V3d(0));
  return b;
}

// At depth 0 both integrators see what lights send straight to Lambertian
// surfaces: the same means, pixel by pixel.
TEST(DepthTest, DirectLightIsTheSameByBothIntegrators) {
  const decltype(Light::kind) lights[] = {
      PointLight{V3d(3, 4, 2), Rgb(30), true},
      PointLight{V3d(3, 4, 2), Rgb(2), false},
      DirectionalLight{V3d(-1, -2, -1), Rgb(2)},
      SpotLight{V3d(3, 4, 2), V3d(-3, -4, -2), Rgb(40), 12, 6},
      QuadLight{V3d(1, 3, 1), {V3d(2, 0, 0), V3d(0, 0, 2)}, Rgb(4), 16},
      QuadLight{V3d(1, 3, 1), {V3d(2, 0, 1), V3d(0, 1, 2)}, Rgb(4), 10},
      SphereLight{V3d(2, 3, 1), 0.7, Rgb(8), 16}};
  for (const auto& light : lights) {
    const SceneBuilder b = DirectScene(light);
    const SamplePlan plan = PixelPlan(24, 16);
    const auto whitted = Runs(b, plan, By("whitted", 0, 4), 16);
    const auto path = Runs(b, plan, By("path", 0, 16), 16);
    int off = 0;
    double squares = 0, noisy = 0;
    for (std::size_t i = 0; i < whitted[0].values.size(); ++i) {
      const Estimate a = GreenOf(whitted, i), c = GreenOf(path, i);
      const double error = std::hypot(a.error, c.error);
      off += std::abs(a.mean - c.mean) > 6 * error + 1e-5;
      if (error < 1e-5) continue;
      squares += std::pow((a.mean - c.mean) / error, 2);
      noisy += 1;
    }
    EXPECT_LE(off, 2) << light.index();
    // With 15 degrees of freedom each, z^2 has the mean 30 / 28 = 1.07.
    if (noisy > 50) {
      EXPECT_LT(squares / noisy, 1.5) << light.index();
    }
  }
}

}  // namespace
}  // namespace rtb
