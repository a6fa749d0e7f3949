#include "core/render/backend.h"

#include <gtest/gtest.h>

#include <cmath>
#include <variant>

#include "tests/core/render/scenes.h"

namespace rtb {
namespace {

using testing::SceneBuilder;

/// Diffuse, mirroring and glass spheres over a checkered plane.
SceneBuilder Spheres() {
  SceneBuilder b;
  const Index floor =
      b.Add(Lambertian{}, CheckerTexture{Rgb(0.8f), Rgb(0.1f), 0.5});
  b.Add(Plane{V3d(0, -1, 0), V3d(0, 1, 0)}, floor);
  b.Add(Sphere{V3d(-1.2, 0, -5), 1}, b.Add(Dielectric{1.5, Rgb(1)}));
  b.Add(Sphere{V3d(1.2, 0, -5.5), 1}, b.Add(Mirror{Rgb(0.9f)}));
  b.Add(Box{V3d(-0.4, -1, -4), V3d(0.4, -0.5, -3.5)}, b.Add(Lambertian{}));
  b.AddLight(PointLight{V3d(2, 5, -1), Rgb(60), true});
  b.scene.background.kind = GradientBackground{Rgb(1), Rgb(0.2f, 0.4f, 0.9f)};
  return b;
}

TEST(BackendTest, SameBytesForAnyNumberOfThreads) {
  const SceneBuilder b = Spheres();
  RenderOptions options;
  options.spp = 4;
  options.threads = 1;
  const Fragments one = b.Render(RegularPlan({23, 9}, 2, 2), options);
  for (const int threads : {2, 3, 0}) {
    options.threads = threads;
    EXPECT_EQ(b.Render(RegularPlan({23, 9}, 2, 2), options).values, one.values);
  }
}

TEST(BackendTest, TheSeedMovesOnlyStratifiedRays) {
  const SceneBuilder b = Spheres();
  RenderOptions first, second;
  second.seed = 1;
  const SamplePlan plan = RegularPlan({20, 8}, 1, 2);
  EXPECT_EQ(b.Render(plan, first).values, b.Render(plan, second).values);
  first.spp = second.spp = 4;
  EXPECT_NE(b.Render(plan, first).values, b.Render(plan, second).values);
}

TEST(BackendTest, AnImageIsAGridOfPixels) {
  // 2 x 2 samples in cells of aspect 1 are the pixels of an image of twice
  // the size.
  const SceneBuilder b = Spheres();
  const Fragments cells = b.Render(RegularPlan({12, 8}, 2, 2, 1.0));
  const Fragments pixels = b.Render(PixelPlan(24, 16));
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 24; ++x) {
      const int cell = (y / 2) * 12 + x / 2;
      const auto sample = static_cast<std::size_t>((y % 2) * 2 + x % 2);
      EXPECT_LT((cells.cell(cell)[sample] -
                 pixels.values[static_cast<std::size_t>(y * 24 + x)])
                    .length(),
                1e-4f);
    }
  }
}

TEST(BackendTest, ManyRaysAverageTheFootprint) {
  // A background gradient is linear in direction y: over one pixel that
  // spans the whole picture the mean of many rays approaches the integral,
  // taken here on a fine grid of single rays.
  SceneBuilder b;
  b.scene.background.kind = GradientBackground{Rgb(0), Rgb(1)};
  b.scene.camera.direction = V3d(0, 1, -1);
  const Fragments fine = b.Render(PixelPlan(64, 64));
  double mean = 0;
  for (const Rgb& v : fine.values) mean += v.x / 4096.0;
  RenderOptions options;
  options.spp = 256;
  EXPECT_NEAR(b.Center(options).x, mean, 5e-4);
}

TEST(BackendTest, RigidMotionLeavesThePictureAlone) {
  SceneBuilder still;
  const Index m = still.Add(Lambertian{Rgb(0.7f)});
  still.Add(Sphere{V3d(0, 0, -4), 1}, m);
  still.Add(Box{V3d(1, -1, -6), V3d(2, 1, -5)}, m);
  still.AddLight(PointLight{V3d(2, 3, 0), Rgb(30), true});
  SceneBuilder moved = still;
  // A quarter turn about y takes (x, y, z) to (z, y, -x); then a shift.
  const V3d shift(10, -3, 7);
  Object group;
  group.shape = Group{};
  group.position = shift;
  group.rotate = V3d(0, 90, 0);
  group.children = still.scene.objects;
  moved.scene.objects = {group};
  moved.scene.lights[0].kind = PointLight{V3d(0, 3, -2) + shift, Rgb(30), true};
  moved.scene.camera.position = shift;
  moved.scene.camera.direction = V3d(-1, 0, 0);
  const Fragments a = still.Render(PixelPlan(40, 30));
  const Fragments c = moved.Render(PixelPlan(40, 30));
  int off = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    if ((a.values[i] - c.values[i]).length() > 1e-4f) ++off;
  }
  EXPECT_LE(off, 3);  // rays along an edge may fall on its other side
}

TEST(BackendTest, CountsRaysByKind) {
  SceneBuilder b;
  b.Add(Plane{V3d(0, 0, -1), V3d(0, 0, 1)}, b.Add(Lambertian{}));
  b.AddLight(DirectionalLight{V3d(0, 0, -1), Rgb(1)});
  auto backend = MakeBackend("embree", b.scene).value();
  ASSERT_TRUE(backend->Render(PixelPlan(10, 10), {}).has_value());
  EXPECT_EQ(backend->ray_counts().camera, 100u);
  EXPECT_EQ(backend->ray_counts().shadow, 100u);
  EXPECT_EQ(backend->ray_counts().secondary(), 0u);
}

// A glass pane before a black sky: each eye ray is reflected and refracted at
// the surface, and the refracted one meets nothing behind it.
TEST(BackendTest, TellsReflectionFromRefraction) {
  SceneBuilder b;
  b.Add(Plane{V3d(0, 0, -1), V3d(0, 0, 1)}, b.Add(Dielectric{}));
  auto backend = MakeBackend("embree", b.scene).value();
  ASSERT_TRUE(backend->Render(PixelPlan(10, 10), {}).has_value());
  EXPECT_EQ(backend->ray_counts(), (RayCounts{100, 100, 100, 0, 0}));
  EXPECT_EQ(backend->ray_counts().total(), 300u);
  RenderOptions path;
  path.integrator = "path";
  path.spp = 16;
  ASSERT_TRUE(backend->Render(PixelPlan(10, 10), path).has_value());
  // The path tracer follows one of the two: the reflected one in 4 % of the
  // rays or a little more (Fresnel's equations, index 1.5).
  const RayCounts counts = backend->ray_counts();
  EXPECT_EQ(counts.reflection + counts.refraction, 1600u);
  EXPECT_GT(counts.reflection, 1600u / 100);
  EXPECT_LT(counts.reflection, 1600u / 10);
  EXPECT_EQ(counts.scattered, 0u);
}

TEST(BackendTest, TimeMovesTheScene) {
  SceneBuilder b;
  Object& lamp = b.Add(Sphere{V3d(0, 0, -3), 0.5}, b.Add(Emissive{Rgb(1)}));
  lamp.path = 0;
  b.scene.paths = {{"p",
                    {V3d(9, 0, 0), V3d(0)},
                    {0, 1},
                    1,
                    false,
                    Path::Interpolation::kLinear}};
  RenderOptions options;
  EXPECT_EQ(b.Center(options), Rgb(0));
  options.time = 1;
  EXPECT_EQ(b.Center(options), Rgb(1));
}

TEST(BackendTest, ACameraMayStandInForTheScenes) {
  SceneBuilder b;
  b.Add(Sphere{V3d(0, 0, 3), 0.5}, b.Add(Emissive{Rgb(1)}));
  RenderOptions options;
  EXPECT_EQ(b.Center(options), Rgb(0));
  options.camera = CameraAt(b.scene, 0);
  options.camera->forward = V3d(0, 0, 1);
  EXPECT_EQ(b.Center(options), Rgb(1));
}

/// A unit sphere on a floor of the given kind, under a slanting sun.
Fragments ContactShadow(const std::variant<Plane, Quad, Disk>& floor) {
  SceneBuilder b;
  const Index m = b.Add(Lambertian{Rgb(0.7f)});
  std::visit([&](const auto& shape) { b.Add(shape, m); }, floor);
  b.Add(Sphere{V3d(0, 1, 0), 1}, m);
  b.AddLight(DirectionalLight{V3d(-1, -1, -0.5), Rgb(2)});
  b.Look(V3d(0.5, 1, 5), V3d(0, 0.3, 0));
  return b.Render(PixelPlan(120, 80));
}

TEST(BackendTest, LargeFloorsLeakNoLightUnderWhatStandsOnThem) {
  // The offset of new rays grows with the primitive's extent: on a floor as
  // large as this it must still be small against the sphere.
  const Fragments plane = ContactShadow(Plane{V3d(0), V3d(0, 1, 0)});
  const double r = 1e4;
  const Fragments quad =
      ContactShadow(Quad{V3d(-r, 0, -r), {V3d(0, 0, 2 * r), V3d(2 * r, 0, 0)}});
  const Fragments disk = ContactShadow(Disk{V3d(0), V3d(0, 1, 0), r});
  for (const Fragments& large : {quad, disk}) {
    int off = 0;
    for (std::size_t i = 0; i < plane.values.size(); ++i) {
      off += (plane.values[i] - large.values[i]).length() > 0.03f;
    }
    EXPECT_LE(off, 48);  // 0.5 %: the horizon, and the shadow's edge
  }
}

TEST(BackendTest, NothingNegativeLeavesTheRenderer) {
  SceneBuilder b;
  b.scene.background.kind = GradientBackground{Rgb(0), Rgb(1)};
  b.scene.camera.vfov = 1;
  b.Look(V3d(0), V3d(0, -1, 0));
  for (const Rgb& v : b.Render(PixelPlan(64, 64)).values) {
    EXPECT_GE(v.x, 0);
  }
}

TEST(BackendTest, NamesThatCannotRunAreErrors) {
  const Scene scene;
  const auto unknown = MakeBackend("optix", scene);
  ASSERT_FALSE(unknown.has_value());
  EXPECT_EQ(unknown.error().kind, ErrorKind::kBadInput);
  EXPECT_NE(unknown.error().ToString().find("embree"), std::string::npos);
  for (const BackendInfo& info : Backends()) {
    EXPECT_EQ(MakeBackend(info.name, scene).has_value(),
              info.check().has_value());
  }
  // Where there is no device, asking for one is an error of its own.
  const auto cuda = MakeBackend("cuda", scene);
  if (!cuda.has_value()) {
    EXPECT_EQ(cuda.error().kind, ErrorKind::kMissing);
  }
}

TEST(BackendTest, UnknownIntegratorIsAnError) {
  const Scene scene;
  auto backend = MakeBackend("embree", scene).value();
  RenderOptions options;
  options.integrator = "radiosity";
  EXPECT_FALSE(backend->Render(PixelPlan(1, 1), options).has_value());
}

}  // namespace
}  // namespace rtb
