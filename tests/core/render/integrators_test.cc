// What holds for any scene, whatever it shows: finite and not negative,
// before PlanRenderer cuts anything off; the same bytes for any number of
// threads.
#include "core/render/integrators.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "core/accel/embree_accel.h"
#include "core/base/parallel.h"
#include "core/scene/load.h"
#include "tests/core/render/measure.h"
#include "tests/core/scene/mesh_shapes.h"
#include "tests/scene_files.h"

namespace rtb {
namespace {

using testing::By;
using testing::SceneBuilder;

/// What an integrator itself answers, unlike a backend, which sanitizes.
struct Raw {
  int values = 0;
  int bad = 0;  ///< NaN, infinite or negative.
};

/// A scene made ready, as the backend does it.
struct Ready {
  explicit Ready(const Scene& scene)
      : geometry(MakeGeometry(Flat(scene), scene.meshes)),
        shading(MakeShadingScene(scene).value()),
        camera(MakeCameraRays(CameraAt(scene, 0), 1.5)) {
    PlaceLights(scene, 0, geometry, &shading);
    std::vector<Rgb> transmittance;
    for (const ObjectData& object : geometry.objects) {
      transmittance.push_back(
          object.light >= 0
              ? Rgb(0)
              : ShadowTransmittance(ViewOf(shading).material(object.material)));
    }
    accel = std::make_unique<EmbreeAccel>(
        EmbreeAccel::Build(geometry, transmittance).value());
  }

  static FlatScene Flat(const Scene& scene) {
    FlatScene flat = Flatten(scene, 0).value();
    EXPECT_TRUE(AddLightShapes(scene, 0, FlatPart::kAll, &flat).has_value());
    return flat;
  }

  template <template <class> class Integrator>
  Raw Values(int max_depth, std::uint32_t per_pixel) const {
    Raw raw;
    Integrator<EmbreeAccel> integrator(*accel, ViewOf(shading), max_depth);
    constexpr int kColumns = 18, kRows = 12;
    // One thread, on which denormals are flushed as everywhere.
    ParallelFor(kColumns * kRows, 1, 1, [&](int begin, int) {
      for (std::uint32_t i = 0; i < per_pixel; ++i) {
        EyeSample eye;
        eye.pattern = static_cast<std::uint32_t>(begin);
        eye.index = i;
        eye.ray = EyeRay(camera, (begin % kColumns + 0.5) / kColumns,
                         (begin / kColumns + 0.5) / kRows);
        RayCounts counts;
        const Rgb value = integrator.Radiance(eye, &counts);
        ++raw.values;
        for (int c = 0; c < 3; ++c) {
          raw.bad += !std::isfinite(value[c]) || value[c] < 0;
        }
      }
    });
    return raw;
  }

  Geometry geometry;
  ShadingScene shading;
  CameraRays camera;
  std::unique_ptr<EmbreeAccel> accel;
};

bool HasPhong(const Scene& scene) {
  for (const Material& m : scene.materials) {
    if (std::holds_alternative<Phong>(m.bsdf)) return true;
  }
  return false;
}

void ExpectFinite(const Scene& scene, const std::string& what,
                  std::uint32_t per_pixel = 2) {
  const Ready ready(scene);
  const int depth = std::min(scene.settings.max_depth, 6);
  EXPECT_EQ(ready.Values<Whitted>(depth, per_pixel).bad, 0) << what;
  if (HasPhong(scene)) return;
  EXPECT_EQ(ready.Values<PathTracer>(depth, per_pixel).bad, 0) << what;
}

TEST(IntegratorsTest, FiniteInEveryCommittedScene) {
  const std::filesystem::path source = RTB_TEST_SOURCE_DIR;
  int scenes = 0;
  for (const char* folder : {"scenes", "tests/data/scenes"}) {
    for (const auto& file : testing::SceneFiles(source / folder)) {
      const Result<Scene> scene = LoadScene(file);
      // every_key names files that are no images: it is there to be read.
      if (!scene || scene->name == "every_key") continue;
      ++scenes;
      ExpectFinite(*scene, file.filename().string());
    }
  }
  EXPECT_GE(scenes, 14);
}

/// One of each shape of a material, under lights that meet surfaces.
SceneBuilder Hostile(const decltype(Material::bsdf)& model, float radiance,
                     double scale) {
  SceneBuilder b;
  const Index m = std::visit([&](auto bsdf) { return b.Add(bsdf); }, model);
  b.Add(Plane{V3d(0, -1, 0) * scale, V3d(0, 1, 0)}, m);
  b.Add(Sphere{V3d(-0.8, 0, 0) * scale, 0.7 * scale}, m);
  // Interpenetrating and touching the sphere, needles, slivers.
  b.Add(Box{V3d(-0.5, -1, -0.5) * scale, V3d(0.5, 0, 0.5) * scale}, m);
  b.Add(Triangle{{V3d(0), V3d(1, 0, 0) * scale, V3d(0.5, 1e-6, 0) * scale}}, m);
  b.Add(Disk{V3d(0.9, 0.3, 0) * scale, V3d(-0.2, 0.1, 1), 0.4 * scale}, m);
  Object& mesh = b.Add(SmoothIcosphere(1), m);
  mesh.scale = V3d(0.4 * scale, 1e-3 * scale, 0.4 * scale);
  mesh.position = V3d(0.3, 0.4, 0.3) * scale;
  b.AddLight(PointLight{V3d(0, -1, 0) * scale, Rgb(radiance), true});
  b.AddLight(PointLight{V3d(1, 1, 1) * scale, Rgb(radiance), false});
  b.AddLight(DirectionalLight{V3d(0, -1, 0), Rgb(radiance)});
  b.AddLight(
      SpotLight{V3d(0, 2, 0) * scale, V3d(0, -1, 0), Rgb(radiance), 1, 0});
  b.AddLight(QuadLight{V3d(-1, -1, -1) * scale,
                       {V3d(2, 0, 0) * scale, V3d(0, 0, 2) * scale},
                       Rgb(radiance),
                       2});
  b.AddLight(
      SphereLight{V3d(-0.8, 0.6, 0) * scale, 0.2 * scale, Rgb(radiance), 2});
  b.SetBackground(Rgb(radiance));
  b.scene.settings.max_depth = 6;
  b.Look(V3d(0.2, 0.6, 3) * scale, V3d(0));
  return b;
}

TEST(IntegratorsTest, FiniteWithHostileMaterials) {
  const decltype(Material::bsdf) models[] = {
      Lambertian{Rgb(1)},    Lambertian{Rgb(0)},       Mirror{Rgb(1)},
      Metal{Rgb(1), 0},      Metal{Rgb(1), 0.01},      Metal{Rgb(0), 0.01},
      Metal{Rgb(1), 1},      Dielectric{1, Rgb(1)},    Dielectric{4, Rgb(1)},
      Plastic{Rgb(1), 1, 0}, Plastic{Rgb(1), 4, 0.01}, Plastic{Rgb(1), 1, 0.01},
      Plastic{Rgb(0), 4, 1}, Plastic{Rgb(1), 4, 0}};
  int number = 0;
  for (const auto& model : models) {
    for (const double scale : {1e-4, 1.0, 1e5}) {
      const SceneBuilder b = Hostile(model, 3, scale);
      ExpectFinite(b.scene,
                   std::to_string(number) + " " + std::to_string(scale), 8);
    }
    ++number;
  }
}

// Radiance near the end of float's range may overflow inside an integrator; a
// backend then answers the largest float, not NaN.
TEST(IntegratorsTest, HugeRadianceStaysWithinFloat) {
  for (const float radiance : {1e30f, 1e37f}) {
    const SceneBuilder b = Hostile(Lambertian{Rgb(0.8f)}, radiance, 1);
    for (const char* integrator : {"whitted", "path"}) {
      for (const Rgb& v :
           b.Render(PixelPlan(24, 16), By(integrator, 3, 4)).values) {
        for (int c = 0; c < 3; ++c) {
          EXPECT_TRUE(std::isfinite(v[c]) && v[c] >= 0) << integrator;
        }
      }
    }
  }
}

TEST(IntegratorsTest, SameBytesForAnyThreadsAndAgain) {
  SceneBuilder b = Hostile(Plastic{Rgb(0.7f), 1.5, 0.2}, 2, 1);
  b.Add(Sphere{V3d(1, -0.5, 1), 0.4}, b.Add(Dielectric{1.5, Rgb(0.9f)}));
  b.Add(Box{V3d(-2, 0, -1), V3d(-1.5, 1, 0)}, b.Add(Emissive{Rgb(2)}));
  for (const char* integrator : {"whitted", "path"}) {
    RenderOptions options = By(integrator, 4, 3);
    options.threads = 1;
    const SamplePlan plan = PixelPlan(40, 24);
    const Fragments one = b.Render(plan, options);
    for (const int threads : {1, 2, 3, 0}) {
      options.threads = threads;
      EXPECT_EQ(b.Render(plan, options).values, one.values)
          << integrator << " " << threads;
    }
    options.seed = 1;
    EXPECT_NE(b.Render(plan, options).values, one.values) << integrator;
  }
}

}  // namespace
}  // namespace rtb
