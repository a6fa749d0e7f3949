// White furnaces: what reflects all light cannot be told from surroundings of
// radiance 1 by the path integrator.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/render/measure.h"
#include "tests/core/scene/mesh_shapes.h"

namespace rtb {
namespace {

using testing::By;
using testing::CenterEstimate;
using testing::Estimate;
using testing::EstimateOf;
using testing::GreenOf;
using testing::Runs;
using testing::SceneBuilder;

using Model = decltype(Material::bsdf);
enum class Shape { kSphere, kBox, kSmoothMesh };

/// A body that fills most of the picture, in a constant background of 1.
SceneBuilder Furnace(const Model& model, Shape shape) {
  SceneBuilder b;
  const Index m = std::visit([&](auto bsdf) { return b.Add(bsdf); }, model);
  if (shape == Shape::kSphere) b.Add(Sphere{V3d(0), 1}, m);
  if (shape == Shape::kBox)
    b.Add(Box{V3d(-1), V3d(1)}, m).rotate = V3d(25, 35, 0);
  if (shape == Shape::kSmoothMesh) b.Add(SmoothIcosphere(3), m);
  b.SetBackground(Rgb(1));
  b.scene.camera.vfov = 24;
  b.Look(V3d(0, 0, 6), V3d(0));
  return b;
}

struct Brightness {
  Estimate mean;    ///< Over the picture, its error from seed to seed.
  double low = 0;   ///< The darkest pixel, lifted by 5 standard errors,
  double high = 0;  ///< and the brightest, lowered likewise.
};

Brightness Measure(const SceneBuilder& b, int max_depth, int spp = 32) {
  const auto pictures =
      Runs(b, PixelPlan(12, 12), By("path", max_depth, spp), 12);
  Brightness result{{}, 1, 1};
  for (std::size_t i = 0; i < pictures[0].values.size(); ++i) {
    const Estimate e = GreenOf(pictures, i);
    result.low = std::min(result.low, e.mean + 5 * e.error);
    result.high = std::max(result.high, e.mean - 5 * e.error);
  }
  std::vector<double> means;
  for (const Fragments& f : pictures) {
    double sum = 0;
    for (const Rgb& v : f.values) sum += v.y / 144;
    means.push_back(sum);
  }
  result.mean = EstimateOf(means);
  return result;
}

/// @param lost at most this much is missing, in the mean and in any pixel.
void ExpectWhite(const Model& model, Shape shape, int max_depth,
                 const char* what, double lost = 0.002,
                 double lost_in_pixel = 0.01) {
  const Brightness b = Measure(Furnace(model, shape), max_depth);
  const int number = static_cast<int>(shape);
  EXPECT_NEAR(b.mean.mean, 1 - lost / 2, lost / 2 + 5 * b.mean.error + 1e-3)
      << what << " " << number;
  EXPECT_GT(b.low, 1 - lost_in_pixel) << what << " " << number;
  EXPECT_LT(b.high, 1.01) << what << " " << number;
}

TEST(FurnaceTest, WhiteLambertianBodiesVanish) {
  ExpectWhite(Lambertian{Rgb(1)}, Shape::kSphere, 0, "lambertian");
  ExpectWhite(Lambertian{Rgb(1)}, Shape::kSphere, 3, "lambertian");
  ExpectWhite(Lambertian{Rgb(1)}, Shape::kBox, 3, "lambertian");
  // Interpolated normals lean up to 5 degrees to the facets here, below which
  // nothing goes: (1 - cos 5) / 2 = 0.2 % of a cosine hemisphere.
  ExpectWhite(Lambertian{Rgb(1)}, Shape::kSmoothMesh, 3, "lambertian", 0.004);
}

TEST(FurnaceTest, MirrorsVanish) {
  for (const Shape shape : {Shape::kSphere, Shape::kBox, Shape::kSmoothMesh}) {
    ExpectWhite(Mirror{Rgb(1)}, shape, 4, "mirror", 1e-6, 1e-5);
    ExpectWhite(Metal{Rgb(1), 0}, shape, 4, "smooth metal", 1e-6, 1e-5);
  }
}

TEST(FurnaceTest, RoughMetalVanishes) {
  for (const double roughness : {0.05, 0.1, 0.2, 0.4, 0.7, 1.0}) {
    const std::string what = "metal " + std::to_string(roughness);
    ExpectWhite(Metal{Rgb(1), roughness}, Shape::kSphere, 3, what.c_str());
    ExpectWhite(Metal{Rgb(1), roughness}, Shape::kBox, 3, what.c_str());
    // Facets cut lobes off where the interpolated normal leans to the view.
    ExpectWhite(Metal{Rgb(1), roughness}, Shape::kSmoothMesh, 3, what.c_str(),
                0.01, 0.15);
  }
}

TEST(FurnaceTest, SmoothPlasticVanishes) {
  for (const double ior : {1.0, 1.5, 2.4}) {
    ExpectWhite(Plastic{Rgb(1), ior, 0}, Shape::kSphere, 3, "plastic");
    ExpectWhite(Plastic{Rgb(1), ior, 0}, Shape::kBox, 3, "plastic");
  }
}

TEST(FurnaceTest, RoughPlasticLosesWhatItsBsdfDoes) {
  // The losses that the BSDF's own tests state over all views of a flat
  // surface; the views of a sphere are distributed the same (area as seen =
  // cosine-weighted), those of the background around it lose nothing.
  struct Case {
    double roughness, least, most;
  };
  for (const Case& c :
       {Case{0.1, 0, 0.002}, {0.4, 0.005, 0.03}, {1.0, 0.03, 0.08}}) {
    SceneBuilder b = Furnace(Plastic{Rgb(1), 1.5, c.roughness}, Shape::kSphere);
    // The sphere's share of the picture, by rays that meet black instead.
    const SceneBuilder black = Furnace(Lambertian{Rgb(0)}, Shape::kSphere);
    const double share = 1 - Measure(black, 0).mean.mean;
    const Estimate white = Measure(b, 3).mean;
    const double loss = (1 - white.mean) / share;
    const double error = 5 * white.error / share + 1e-3;
    EXPECT_GT(loss, c.least - error) << c.roughness;
    EXPECT_LT(loss, c.most + error) << c.roughness;
  }
}

TEST(FurnaceTest, GlassVanishesButForWhatIsStillInside) {
  // In a sphere each internal hit is at the angle of the entry: of the share
  // 1 - F that enters, F^(d-1) is still inside after d bounces. The rays to a
  // sphere are distributed over its disk, so the loss is below
  // max (1 - F) F^(d-1) = 1 / (e (d - 1)) at worst in one place, and 0.2 % of
  // the picture at d = 32.
  for (const double ior : {1.0, 1.33, 1.5, 2.4}) {
    ExpectWhite(Dielectric{ior, Rgb(1)}, Shape::kSphere, 32, "glass", 0.002,
                0.03);
    ExpectWhite(Dielectric{ior, Rgb(1)}, Shape::kSmoothMesh, 48, "glass", 0.01,
                0.06);
  }
  ExpectWhite(Dielectric{1.5, Rgb(1)}, Shape::kBox, 64, "glass", 0.002, 0.02);
}

TEST(FurnaceTest, TruncatedGlassLosesItsTail) {
  // Straight on F = 0.04 each time: 1 - (1 - F) F^(d-1) after d bounces.
  for (const int depth : {1, 2, 3}) {
    const SceneBuilder b = Furnace(Dielectric{1.5, Rgb(1)}, Shape::kSphere);
    const Estimate e = CenterEstimate(b, By("path", depth, 1024));
    const double tail = 0.96 * std::pow(0.04, depth - 1);
    EXPECT_NEAR(e.mean, 1 - tail, 5 * e.error + 1e-4) << depth;
  }
}

TEST(FurnaceTest, InsideGlassAllIsWhiteToo) {
  // Seen from within, through total reflection for many directions.
  SceneBuilder b = Furnace(Dielectric{1.5, Rgb(1)}, Shape::kSphere);
  b.Look(V3d(0.8, 0, 0), V3d(0.8, 0, -1));
  b.scene.camera.vfov = 80;
  const Brightness inside = Measure(b, 64);
  // What meets the surface at over 41.8 degrees never leaves a sphere.
  EXPECT_LT(inside.high, 1.005);
  b.Look(V3d(0.5, 0, 0), V3d(0.5, 0, -1));
  // From radius 0.5 the incidence is at most asin(0.5) = 30 degrees.
  const Brightness all = Measure(b, 16);
  EXPECT_NEAR(all.mean.mean, 1, 5 * all.mean.error + 1e-4);
  EXPECT_GT(all.low, 0.999);
}

}  // namespace
}  // namespace rtb
