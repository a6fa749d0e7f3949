// The integrator on vectors against the one that follows path by path: the
// same bytes, the same rays, on every instruction set.
#include "core/render/wide/wide_renderer.h"

#include <gtest/gtest.h>

#include "tests/core/render/measure.h"
#include "tests/simd_targets.h"

namespace rtb {
namespace {

using testing::By;
using testing::SceneBuilder;

/// All shapes and materials that vectors know, some squeezed and turned.
SceneBuilder Everything() {
  SceneBuilder b;
  const Index clay = b.Add(Lambertian{Rgb(0.7f, 0.6f, 0.5f)});
  b.Add(Plane{V3d(0, -1, 0), V3d(0.1, 1, 0)}, clay);
  b.Add(Disk{V3d(0, 0.2, -9), V3d(0.3, 0, 1), 4},
        b.Add(Metal{Rgb(0.9f, 0.8f, 0.5f), 0.35}));
  b.Add(Sphere{V3d(-1.2, 0, -5), 1}, b.Add(Dielectric{1.5, Rgb(0.9f, 1, 1)}));
  b.Add(Sphere{V3d(-1.2, 0, -5), 0.6}, b.Add(Dielectric{1.2, Rgb(1)}));
  b.Add(Sphere{V3d(1.2, 0, -5.5), 1}, b.Add(Mirror{Rgb(0.9f)}));
  Object& egg = b.Add(Sphere{V3d(0), 1}, b.Add(Metal{Rgb(0.6f), 0.7}));
  egg.position = V3d(0.2, -0.4, -4);
  egg.rotate = V3d(20, 30, 40);
  egg.scale = V3d(0.5, 0.3, 0.8);
  b.Add(Sphere{V3d(2.4, 0.5, -4), 0.5}, b.Add(Metal{Rgb(0.9f, 0.5f, 0.2f), 0}));
  b.Add(Disk{V3d(-2, 1, -4), V3d(1, -1, 0.2), 0.7}, clay);
  b.scene.background.kind =
      GradientBackground{Rgb(1, 0.9f, 0.7f), Rgb(0.1f, 0.3f, 1.5f)};
  return b;
}

struct Rendering {
  Fragments fragments;
  RayCounts counts;
};

Rendering Draw(const SceneBuilder& b, const SamplePlan& plan,
               RenderOptions options, bool vectors) {
  options.vectors = vectors;
  auto backend = MakeBackend("embree", b.scene).value();
  Rendering rendering{backend->Render(plan, options).value(), {}};
  rendering.counts = backend->ray_counts();
  return rendering;
}

/// Both ways give the same, and the one is on vectors where it ought to be.
void ExpectSame(const SceneBuilder& b, const SamplePlan& plan,
                const RenderOptions& options) {
  const Rendering scalar = Draw(b, plan, options, false);
  Rendering wide = Draw(b, plan, options, true);
  EXPECT_EQ(wide.fragments.values, scalar.fragments.values);
  EXPECT_EQ(wide.fragments.variances, scalar.fragments.variances);
  EXPECT_EQ(scalar.counts.on_vectors, 0u);
  EXPECT_EQ(wide.counts.on_vectors, wide.counts.camera);
  wide.counts.on_vectors = 0;
  EXPECT_EQ(wide.counts, scalar.counts);
}

TEST(WideRendererTest, SameBytesAsPathByPathOnEveryTarget) {
  const SceneBuilder b = Everything();
  ForEachSimdTarget(
      [&] { ExpectSame(b, PixelPlan(40, 26), By("path", 7, 33)); });
}

// 300 rays are more than a batch holds, 5 fill no vector, and 1 goes without
// jitter.
TEST(WideRendererTest, SameBytesForAnyNumberOfRays) {
  for (const int spp : {1, 2, 5, 300}) {
    SCOPED_TRACE(spp);
    ExpectSame(Everything(), RegularPlan({7, 5}, 2, 1), By("path", 5, spp));
  }
}

TEST(WideRendererTest, SameBytesForAnyDepth) {
  for (const int depth : {0, 1, 30}) {
    SCOPED_TRACE(depth);
    ExpectSame(Everything(), PixelPlan(24, 16), By("path", depth, 4));
  }
}

TEST(WideRendererTest, SameBytesForChosenCellsSeedsAndThreads) {
  SamplePlan plan = RegularPlan({9, 6}, 2, 2);
  plan.cells = {3, 50, 3, 17, 8};
  plan.samples_before = {0, 0, 4, 0, 8};
  RenderOptions options = By("path", 5, 6);
  options.seed = 0x123456789ABCDEF0;
  for (const int threads : {1, 3}) {
    options.threads = threads;
    ExpectSame(Everything(), plan, options);
  }
}

TEST(WideRendererTest, SameBytesUnderBlackAndConstantSkies) {
  for (const float sky : {0.0f, 0.5f}) {
    SceneBuilder b = Everything();
    b.SetBackground(Rgb(sky));
    ExpectSame(b, PixelPlan(16, 10), By("path", 5, 4));
  }
}

TEST(WideRendererTest, OtherScenesAreFollowedPathByPath) {
  const auto on_vectors = [](const SceneBuilder& b) {
    return Draw(b, PixelPlan(2, 2), By("path", 2, 2), true).counts.on_vectors;
  };
  SceneBuilder lamp = Everything();
  lamp.AddLight(PointLight{V3d(0, 3, 0), Rgb(1), true});
  EXPECT_EQ(on_vectors(lamp), 0u);
  SceneBuilder box = Everything();
  box.Add(Box{V3d(-1), V3d(1)}, 0);
  EXPECT_EQ(on_vectors(box), 0u);
  SceneBuilder checker = Everything();
  checker.Add(Sphere{}, checker.Add(Lambertian{}, CheckerTexture{}));
  EXPECT_EQ(on_vectors(checker), 0u);
  SceneBuilder glow = Everything();
  glow.Add(Sphere{}, glow.Add(Emissive{Rgb(1)}));
  EXPECT_EQ(on_vectors(glow), 0u);
  SceneBuilder plastic = Everything();
  plastic.Add(Sphere{}, plastic.Add(Plastic{}));
  EXPECT_EQ(on_vectors(plastic), 0u);
  SceneBuilder many = Everything();
  for (int i = 0; i < WideScene::kMost; ++i) many.Add(Sphere{V3d(i)}, 0);
  EXPECT_EQ(on_vectors(many), 0u);
}

}  // namespace
}  // namespace rtb
