// Closed forms of the light that falls on a plane, through the whole renderer
// and by both integrators. The plane y = 0 has albedo 0.6; what the camera
// sees at the origin is 0.6 E / pi. On a plane alone nothing comes back, so
// the path integrator's depth does not matter: at depth 0 all comes by
// next-event estimation, at depth 1 by both techniques, weighted.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "core/image/io.h"
#include "tests/core/render/measure.h"

namespace rtb {
namespace {

using testing::By;
using testing::CenterEstimate;
using testing::Estimate;
using testing::kPiExact;
using testing::SceneBuilder;

constexpr double kAlbedo = 0.6;

SceneBuilder FloorUnder(const decltype(Light::kind)& light) {
  SceneBuilder b;
  b.Add(Plane{V3d(0), V3d(0, 1, 0)}, b.Add(Lambertian{Rgb(0.6f)}));
  b.AddLight(light);
  b.Look(V3d(1, 3, 2), V3d(0));
  return b;
}

/// Lights without extent leave no noise: float's precision alone.
void ExpectExactly(const decltype(Light::kind)& light, double irradiance) {
  const SceneBuilder b = FloorUnder(light);
  for (const RenderOptions& options :
       {By("whitted", 0), By("path", 0), By("path", 3)}) {
    const Estimate e = CenterEstimate(b, options, 2);
    EXPECT_NEAR(e.mean, kAlbedo * irradiance / kPiExact,
                1e-5 * irradiance + 1e-12)
        << options.integrator << " " << options.max_depth;
  }
}

/// Lights with extent: within 4 standard errors of what 32 seeds give, and
/// these small.
void ExpectOnAverage(const SceneBuilder& b, double irradiance) {
  for (const RenderOptions& options :
       {By("whitted", 0, 64), By("path", 0, 256), By("path", 2, 256)}) {
    const Estimate e = CenterEstimate(b, options, 32);
    const double expected = kAlbedo * irradiance / kPiExact;
    EXPECT_NEAR(e.mean, expected, 4 * e.error + 2e-5 * expected)
        << options.integrator << " " << options.max_depth;
    EXPECT_LT(e.error, 0.01 * expected)
        << options.integrator << " " << options.max_depth;
  }
}

TEST(IrradianceTest, PointLight) {
  // At (4, 3, 0): d = 5, cos = 3/5.
  ExpectExactly(PointLight{V3d(4, 3, 0), Rgb(7), true}, 7 * 0.6 / 25);
  ExpectExactly(PointLight{V3d(4, 3, 0), Rgb(7), false}, 7 * 0.6);
}

TEST(IrradianceTest, DirectionalLight) {
  ExpectExactly(DirectionalLight{V3d(-3, -4, 0), Rgb(5)}, 5 * 0.8);
}

TEST(IrradianceTest, SpotInItsConeItsPenumbraAndOutside) {
  // From (4, 3, 0) the origin lies along (-4, -3, 0) / 5. The axis is turned
  // away from there by `angle`; the cone is 20 degrees, the penumbra 10.
  const struct {
    double angle, share;
  } cases[] = {{0, 1}, {19.9, 1}, {22.5, 1 - 0.15625}, {25, 0.5}, {30.1, 0}};
  // smoothstep(1/4) = 3/16 - 2/64 = 0.15625.
  const double straight = std::atan2(-3.0, -4.0);
  for (const auto& c : cases) {
    const double a = straight + c.angle * kPiExact / 180;
    ExpectExactly(SpotLight{V3d(4, 3, 0), V3d(std::cos(a), std::sin(a), 0) * 2,
                            Rgb(7), 20, 10},
                  c.share * 7 * 0.6 / 25);
  }
}

TEST(IrradianceTest, SphereLight) {
  // E = pi L (r / d)^2 cos for a sphere above the horizon, at any distance.
  const struct {
    V3d center;
    double radius;
  } cases[] = {{V3d(0, 2, 0), 1.9}, {V3d(4, 3, 0), 1.5}, {V3d(40, 30, 0), 1}};
  for (const auto& c : cases) {
    SceneBuilder b = FloorUnder(SphereLight{c.center, c.radius, Rgb(3), 16});
    // From within the gap, where the sphere hangs low.
    b.Look(V3d(-1, 0.05, 0), V3d(0));
    const double d2 = c.center.length2();
    ExpectOnAverage(b, kPiExact * 3 * c.radius * c.radius / d2 * c.center.y /
                           std::sqrt(d2));
  }
}

/// Lambert's formula: E = L / 2 |sum of Theta_i (Gamma_i . n)| over the edges
/// of a polygon above the horizon, Theta_i the angle an edge subtends and
/// Gamma_i the unit normal of the plane through it and the origin.
double LambertsFormula(const std::vector<V3d>& corners, double radiance) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const V3d& a = corners[i];
    const V3d& b = corners[(i + 1) % corners.size()];
    const V3d normal = a.cross(b);
    const double angle = std::atan2(normal.length(), a.dot(b));
    sum += angle * normal.y / normal.length();
  }
  return radiance / 2 * std::abs(sum);
}

/// A quad light that shines downwards, however its edges run.
double QuadIrradiance(const QuadLight& quad) {
  const V3d& c = quad.corner;
  const V3d& e0 = quad.edges[0];
  const V3d& e1 = quad.edges[1];
  return LambertsFormula({c, c + e0, c + e0 + e1, c + e1}, quad.radiance.x);
}

TEST(IrradianceTest, QuadLight) {
  // A wide rectangle, a slanting parallelogram, a leaning one, a far one.
  for (const QuadLight& quad :
       {QuadLight{V3d(-1, 1, -2), {V3d(3, 0, 0), V3d(0, 0, 5)}, Rgb(2), 16},
        QuadLight{V3d(-1, 1, -2), {V3d(3, 0, 1), V3d(2, 0, 5)}, Rgb(2), 16},
        QuadLight{V3d(1, 0.5, -2), {V3d(0, 0, 3), V3d(1, 2, 0)}, Rgb(2), 9},
        QuadLight{V3d(20, 30, 0), {V3d(1, 0, 0), V3d(0, 0, 1)}, Rgb(2), 4}}) {
    SceneBuilder b = FloorUnder(quad);
    b.Look(V3d(-1, 0.3, -3), V3d(0));
    ExpectOnAverage(b, QuadIrradiance(quad));
  }
}

TEST(IrradianceTest, QuadLightsShineFromTheirFrontAlone) {
  ExpectExactly(
      QuadLight{V3d(-1, 5, -1), {V3d(0, 0, 2), V3d(2, 0, 0)}, Rgb(2), 4}, 0);
}

/// A plane of that normal under a background, by path.
void ExpectUnderSky(const Background& background, const V3d& normal,
                    double radiance, double tolerance) {
  SceneBuilder b;
  b.Add(Plane{V3d(0), normal}, b.Add(Lambertian{Rgb(0.6f)}));
  b.scene.background = background;
  b.Look(normal * 2.0 + V3d(0.3, 0.1, 0.4), V3d(0));
  for (const int depth : {0, 2}) {
    const Estimate e = CenterEstimate(b, By("path", depth, 1024), 32);
    EXPECT_NEAR(e.mean, kAlbedo * radiance,
                4 * e.error + tolerance * kAlbedo * radiance)
        << depth;
    EXPECT_LT(e.error, 0.01 * radiance);
  }
}

TEST(IrradianceTest, GradientBackground) {
  // E / pi is the background at the cosine-weighted mean of y over the
  // hemisphere around n, which is 2/3 n.y.
  Background sky;
  sky.kind = GradientBackground{Rgb(0.5f), Rgb(3)};
  for (const V3d& n : {V3d(0, 1, 0), V3d(1, 0, 0), V3d(0.6, -0.8, 0)}) {
    ExpectUnderSky(sky, n, 0.5 + 2.5 * 0.5 * (2.0 / 3 * n.y + 1), 1e-5);
  }
}

/// A sky of 16 x 8 texels with one bright spot above the horizon.
Image Sky() {
  Image image(16, 8);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 16; ++x) {
      image.at(x, y) = Rgb(0.1f + 0.02f * static_cast<float>((x * 5 + y) % 7));
    }
  }
  image.at(5, 2) = Rgb(40);
  return image;
}

/// What the format says of a direction: longitude 0 (-z) at the center, +x to
/// the right, +y on top; interpolated between texel centers.
double SkyRadiance(const Image& image, const V3d& d) {
  const double x = (0.5 + std::atan2(d.x, -d.z) / (2 * kPiExact)) * 16 - 0.5;
  const double y = std::acos(d.y) / kPiExact * 8 - 0.5;
  const double left = std::floor(x), top = std::floor(y);
  double sum = 0;
  for (int j = 0; j < 2; ++j) {
    for (int i = 0; i < 2; ++i) {
      const int column = (static_cast<int>(left) + i + 16) % 16;
      const int row = std::clamp(static_cast<int>(top) + j, 0, 7);
      const double wx = i == 0 ? 1 - (x - left) : x - left;
      const double wy = j == 0 ? 1 - (y - top) : y - top;
      sum += wx * wy * image.at(column, row).y;
    }
  }
  return sum;
}

TEST(IrradianceTest, ImageBackground) {
  const Image image = Sky();
  const auto file =
      std::filesystem::path(::testing::TempDir()) / "irradiance_sky.exr";
  ASSERT_TRUE(WriteExr(file, image, ExrType::kFloat).has_value());
  // E / pi of a floor: the mean over cosine-weighted directions, by midpoints.
  constexpr int kSteps = 1000;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    for (int j = 0; j < kSteps; ++j) {
      const double y = std::sqrt((i + 0.5) / kSteps);
      const double phi = 2 * kPiExact * (j + 0.5) / kSteps;
      const double r = std::sqrt(1 - y * y);
      sum += SkyRadiance(image, V3d(r * std::cos(phi), y, r * std::sin(phi)));
    }
  }
  Background sky;
  sky.kind = ImageBackground{file};
  ExpectUnderSky(sky, V3d(0, 1, 0), sum / kSteps / kSteps, 1e-4);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace rtb
