/// @file
/// The expressions that the exporter relies on, each against its formula in
/// pixels that the installed POV-Ray renders. Pixels are half floats: relative
/// error 2^-11 = 4.9e-4.
#include "reference/povray.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "core/base/file.h"
#include "core/base/process.h"
#include "core/image/io.h"
#include "tests/reference/scene_maker.h"

namespace rtb {
namespace {

constexpr double kPi = std::numbers::pi;

#define SKIP_WITHOUT_POVRAY() \
  if (!FindProgram("povray")) GTEST_SKIP() << "povray is not installed"

std::filesystem::path OutputOfThisTest() {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  return std::filesystem::path(testing::TempDir()) /
         (std::string("rtb_") + info->test_suite_name() + "." + info->name()) /
         "out.exr";
}

/// The reference of a scene, width x height, one ray per pixel unless told.
Image Pixels(const Scene& scene, int width, int height, int spp = 1) {
  const auto output = OutputOfThisTest();
  const Status done =
      RenderPovReference(scene, {width, height, spp, 0, output}, nullptr);
  EXPECT_TRUE(done.has_value()) << done.error().ToString();
  const Result<Image> image = ReadLinear(output);
  EXPECT_TRUE(image.has_value());
  return image.value_or(Image(width, height));
}

/// Unit direction through pixel (x, y) of MakeScene's camera.
V3d Direction(const Image& image, int x, int y) {
  const double h = image.height();
  return V3d(2 * (x + 0.5 - image.width() / 2.0) / h,
             -2 * (y + 0.5 - h / 2) / h, -1)
      .normalized();
}

/// Expects a function of the view direction in every pixel for which it has a
/// value (a negative first component: no value).
template <class Function>
void ExpectEverywhere(const Image& image, double tolerance,
                      const Function& expected) {
  int tested = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const V3d want = expected(Direction(image, x, y));
      if (want.x < 0) continue;
      ++tested;
      for (int i = 0; i < 3; ++i) {
        ASSERT_NEAR(image.at(x, y)[i], want[i], tolerance * want[i] + 1e-7)
            << "pixel " << x << "," << y << " channel " << i;
      }
    }
  }
  EXPECT_GT(tested, 100);
}

constexpr double kHalf = 6e-4;
const V3d kNoValue(-1);

/// What a white diffuse point at p with normal +y shows under a point light.
double UnderPointLight(const V3d& p, const V3d& light) {
  const V3d to_light = light - p;
  return to_light.y / std::pow(to_light.length(), 3) / kPi;
}

TEST(PovRayTest, PointLightOnAPlane) {
  SKIP_WITHOUT_POVRAY();
  Scene scene = MakeScene();
  const V3d light(1, 1, -3);
  AddObject(&scene, Plane{V3d(0, -1, 0), V3d(0, 1, 0)},
            AddMaterial(&scene, Lambertian{Rgb(0.5f, 0.6f, 0.7f)}));
  AddLight(&scene, PointLight{light, Rgb(10, 20, 30), true});
  // rho / pi * I * cos / d^2
  ExpectEverywhere(Pixels(scene, 48, 32), kHalf, [&](const V3d& d) {
    if (d.y >= -0.05) return kNoValue;
    return V3d(5, 12, 21) * UnderPointLight(d / -d.y, light);
  });
}

TEST(PovRayTest, LightsWithoutFalloffAndAmbient) {
  SKIP_WITHOUT_POVRAY();
  Scene scene = MakeScene();
  scene.settings.ambient = Rgb(0.1f, 0.2f, 0.3f);
  AddObject(&scene, Plane{V3d(0, -1, 0), V3d(0, 1, 0)},
            AddMaterial(&scene, Lambertian{Rgb(0.5f)}));
  AddLight(&scene, DirectionalLight{V3d(3, -4, 0), Rgb(1, 2, 3)});
  AddLight(&scene, PointLight{V3d(0, 4, 0), Rgb(2), false});
  // Directional: cos = 0.8. Point at height 5 over the plane: cos = 5 / d.
  ExpectEverywhere(Pixels(scene, 48, 32), kHalf, [&](const V3d& d) {
    if (d.y >= -0.05) return kNoValue;
    const double cosine = 5 / (V3d(0, 4, 0) - d / -d.y).length();
    return V3d(1, 2, 3) * (0.5 * 0.8 / kPi) + V3d(0.5 * 2 * cosine / kPi) +
           V3d(0.1, 0.2, 0.3) * 0.5;
  });
}

TEST(PovRayTest, MetalIsSchlicksFresnel) {
  SKIP_WITHOUT_POVRAY();
  Scene scene = MakeScene();
  scene.background.kind = ConstantBackground{Rgb(2)};
  AddObject(&scene, Plane{V3d(0, -1, 0), V3d(0, 1, 0)},
            AddMaterial(&scene, Metal{Rgb(0.9f, 0.5f, 0.2f), 0}));
  ExpectEverywhere(Pixels(scene, 48, 32), kHalf, [](const V3d& d) {
    if (d.y >= 0) return V3d(2);
    const V3d f0(0.9, 0.5, 0.2);
    return (f0 + (V3d(1) - f0) * std::pow(1 + d.y, 5)) * 2.0;
  });
}

double Fresnel(double cos_i, double eta) {
  const double cos_t = std::sqrt(1 - eta * eta * (1 - cos_i * cos_i));
  const double s = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
  const double p = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
  return (s * s + p * p) / 2;
}

TEST(PovRayTest, TintMultipliesAtEachCrossingAndDepthEndsInBlack) {
  SKIP_WITHOUT_POVRAY();
  // A slab before white. Depth 3: the outer reflection (1 bounce), straight
  // through (2 bounces), and back out of the front after one inner reflection
  // (3 bounces) are seen; the rest is black.
  Scene scene = MakeScene();
  scene.settings.max_depth = 3;
  scene.background.kind = ConstantBackground{Rgb(1)};
  AddObject(&scene, Box{V3d(-99, -99, -4), V3d(99, 99, -3)},
            AddMaterial(&scene, Dielectric{1.5, Rgb(0.9f, 0.5f, 0.2f)}));
  ExpectEverywhere(Pixels(scene, 48, 32), kHalf, [](const V3d& d) {
    const double f = Fresnel(-d.z, 1 / 1.5);
    const double t2 = (1 - f) * (1 - f);
    const V3d tint(0.9, 0.5, 0.2);
    return V3d(f) + tint * tint * (t2 + t2 * f);
  });
}

TEST(PovRayTest, ShadowRaysAreTintedAtEachCrossing) {
  SKIP_WITHOUT_POVRAY();
  Scene scene = MakeScene();
  AddObject(&scene, Plane{V3d(0, -1, 0), V3d(0, 1, 0)},
            AddMaterial(&scene, Lambertian{Rgb(1)}));
  AddObject(&scene, Box{V3d(-99, 2, -99), V3d(99, 3, 99)},
            AddMaterial(&scene, Dielectric{1.5, Rgb(0.9f, 0.5f, 0.2f)}));
  const V3d light(1, 9, -3);
  AddLight(&scene, PointLight{light, Rgb(1000), true});
  ExpectEverywhere(Pixels(scene, 48, 32), kHalf, [&](const V3d& d) {
    if (d.y >= -0.1) return kNoValue;
    return V3d(0.81, 0.25, 0.04) * 1000.0 * UnderPointLight(d / -d.y, light);
  });
}

TEST(PovRayTest, GradientBackground) {
  SKIP_WITHOUT_POVRAY();
  Scene scene = MakeScene();
  scene.background.kind =
      GradientBackground{Rgb(0.2f, 0.3f, 4), Rgb(0.9f, 0.5f, 0.1f)};
  const auto sky = [](const V3d& d) {
    const V3d bottom(0.2, 0.3, 4), top(0.9, 0.5, 0.1);
    return bottom + (top - bottom) * (0.5 * (d.y + 1));
  };
  ExpectEverywhere(Pixels(scene, 48, 32), kHalf, sky);
  // Straight up and down, where a wrapped pattern would show.
  scene.camera.direction = V3d(0, 1, 0);
  scene.camera.up = V3d(0, 0, 1);
  EXPECT_NEAR(Pixels(scene, 9, 9).at(4, 4).z, 0.1, 1e-3);
  scene.camera.direction = V3d(0, -1, 0);
  EXPECT_NEAR(Pixels(scene, 9, 9).at(4, 4).z, 4, 4e-3);
}

/// 1 where the format's checker of cells `size` is even at p + n size / 1000.
double Even(const V3d& p, const V3d& n, double size) {
  const V3d q = p / size + n * 0.001;
  const double sum = std::floor(q.x) + std::floor(q.y) + std::floor(q.z);
  return std::fmod(std::abs(sum), 2) == 0 ? 1 : 0;
}

/// Shows a checker by itself: emission.
Index GlowingChecker(Scene* scene, double size) {
  return AddMaterial(scene, Emissive{}, CheckerTexture{Rgb(1), Rgb(0), size});
}

TEST(PovRayTest, CheckerOnCellBordersLooksOutwards) {
  SKIP_WITHOUT_POVRAY();
  // The wall z = -2 lies on a cell border; seen against its normal +z, and,
  // for a wall with normal -z, from behind.
  for (const double facing : {1.0, -1.0}) {
    Scene scene = MakeScene();
    AddObject(&scene, Plane{V3d(0, 0, -2), V3d(0, 0, facing)},
              GlowingChecker(&scene, 0.5));
    ExpectEverywhere(Pixels(scene, 48, 32), kHalf, [&](const V3d& d) {
      return V3d(Even(d * (-2 / d.z), V3d(0, 0, facing), 0.5));
    });
  }
}

TEST(PovRayTest, CheckerOnASphereLooksOutwards) {
  SKIP_WITHOUT_POVRAY();
  Scene scene = MakeScene();
  const V3d center(0.1, 0.2, -4);
  AddObject(&scene, Sphere{center, 1.3}, GlowingChecker(&scene, 0.25));
  const Image image = Pixels(scene, 480, 320);
  int hits = 0, wrong = 0;
  for (int y = 0; y < 320; ++y) {
    for (int x = 0; x < 480; ++x) {
      const V3d d = Direction(image, x, y);
      const double b = d.dot(center);
      const double q = b * b - center.length2() + 1.3 * 1.3;
      if (q < 1e-6) continue;
      const V3d p = d * (b - std::sqrt(q));
      ++hits;
      if (image.at(x, y).x != Even(p, (p - center) / 1.3, 0.25)) ++wrong;
    }
  }
  EXPECT_GT(hits, 9000);
  EXPECT_EQ(wrong, 0);
}

TEST(PovRayTest, CheckerLiesInObjectSpace) {
  SKIP_WITHOUT_POVRAY();
  // Turned by 90 degrees about z and moved by (0.31, 0, 0), scaled by 2: world
  // p = (0.31, 0, 0) + 2 (-y, x, z), so object x = p.y / 2 and so on.
  Scene scene = MakeScene();
  Object& wall = AddObject(&scene, Plane{V3d(0, 0, -1.1), V3d(0, 0, 1)},
                           GlowingChecker(&scene, 0.35));
  wall.position = V3d(0.31, 0, 0);
  wall.rotate = V3d(0, 0, 90);
  wall.scale = V3d(2);
  ExpectEverywhere(Pixels(scene, 49, 33), kHalf, [](const V3d& d) {
    const V3d p = d * (-2.2 / d.z) - V3d(0.31, 0, 0);
    return V3d(Even(V3d(p.y, -p.x, p.z) / 2.0, V3d(0, 0, 1), 0.35));
  });
}

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

TEST(PovRayTest, SizeOfTheSceneDoesNotMatter) {
  SKIP_WITHOUT_POVRAY();
  // POV-Ray's shadow tolerance is 1e-3 units: in a world of millimeters it
  // would swallow the sphere's shadow on a wall right behind it.
  std::vector<Image> images;
  for (const double k : {1.0, 0.001, 1000.0}) {
    Scene scene = MakeScene();
    const Index white = AddMaterial(&scene, Lambertian{Rgb(0.8f)});
    AddObject(&scene, Plane{V3d(0, 0, -4) * k, V3d(0, 0, 1)}, white);
    AddObject(&scene, Sphere{V3d(0, 0, -3.5) * k, 0.45 * k}, white);
    AddLight(&scene, PointLight{V3d(2, 2, -2) * k,
                                Rgb(static_cast<float>(9 * k * k)), true});
    images.push_back(Pixels(scene, 48, 32));
  }
  int different = 0;
  for (std::size_t i = 0; i < images[0].pixels().size(); ++i) {
    const Rgb& a = images[0].pixels()[i];
    for (std::size_t j : {1u, 2u}) {
      if ((images[j].pixels()[i] - a).length() > 1e-3f) ++different;
    }
  }
  EXPECT_EQ(different, 0);
}

TEST(PovRayTest, SamplesAreTheMeanOfAFinerPicture) {
  SKIP_WITHOUT_POVRAY();
  Scene scene = MakeScene();
  // An irrational cell, so that no ray meets a border exactly.
  AddObject(&scene, Plane{V3d(0, -1, 0), V3d(0, 1, 0)},
            GlowingChecker(&scene, kPi / 9));
  // At two million rays a band 600 x 450 pixels of 9 rays make two bands, of
  // 370 rows and of 80.
  const Image coarse = Pixels(scene, 600, 450, 9);
  const Image fine = Pixels(scene, 1800, 1350);
  for (int y = 0; y < 450; y += 3) {
    for (int x = 0; x < 600; x += 7) {
      float sum = 0;
      for (int i = 0; i < 9; ++i)
        sum += fine.at(3 * x + i % 3, 3 * y + i / 3).x;
      // Ninths as halves.
      ASSERT_NEAR(coarse.at(x, y).x, sum / 9, 5e-4) << x << "," << y;
    }
  }
}

TEST(PovRayTest, WritesProvenanceAndCleansUp) {
  SKIP_WITHOUT_POVRAY();
  Scene scene = MakeScene();
  scene.sha256 = "abc";
  const auto output = OutputOfThisTest();
  std::vector<double> shares;
  const Status done = RenderPovReference(
      scene, {12, 8, 4, 0, output},
      [&](double share, const std::string&) { shares.push_back(share); });
  ASSERT_TRUE(done.has_value()) << done.error().ToString();
  EXPECT_EQ(shares, (std::vector<double>{0, 1}));
  EXPECT_FALSE(std::filesystem::exists(output.string() + ".work"));
  const Result<std::string> text = ReadFile(output.string() + ".json");
  ASSERT_TRUE(text.has_value());
  const auto json = nlohmann::json::parse(*text);
  EXPECT_EQ(json["renderer"], "povray");
  EXPECT_THAT(json["version"].get<std::string>(),
              testing::StartsWith("POV-Ray 3."));
  EXPECT_EQ(json["scene"]["sha256"], "abc");
  EXPECT_EQ(json["settings"]["spp"], 4);
  EXPECT_EQ(json["image"]["width"], 12);
  EXPECT_EQ(json["image"]["sha256"], *Sha256File(output));
}

TEST(PovRayTest, AsksForASquareNumberOfSamples) {
  const Status done = RenderPovReference(
      MakeScene(), {8, 8, 12, 0, OutputOfThisTest()}, nullptr);
  ASSERT_FALSE(done.has_value());
  EXPECT_EQ(done.error().kind, ErrorKind::kBadInput);
  EXPECT_EQ(done.error().place, "--spp");
}

TEST(PovRayTest, ReferencePathNamesSceneAndRenderer) {
  EXPECT_EQ(ReferencePath("reference/images", "cornell", "povray"),
            std::filesystem::path("reference/images/cornell.povray.exr"));
}

}  // namespace
}  // namespace rtb
