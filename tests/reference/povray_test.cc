/// @file
/// The expressions that the exporter relies on, each against its formula in
/// pixels that the installed POV-Ray renders. Pixels are half floats: relative
/// error 2^-11 = 4.9e-4.
#include "reference/povray.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/base/file.h"
#include "tests/reference/pov_pixels.h"

namespace rtb {
namespace {

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
  EXPECT_EQ(shares, (std::vector<double>{0, 0.25, 0.5, 0.75, 1}));
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

TEST(PovRayTest, ReferencePathNamesTimesOtherThanZero) {
  EXPECT_EQ(ReferencePath("", "cornell", "povray", 2),
            std::filesystem::path("cornell.t2.povray.exr"));
  EXPECT_EQ(ReferencePath("", "cornell", "povray", 0.1),
            std::filesystem::path("cornell.t0.1.povray.exr"));
  EXPECT_EQ(ReferencePath("", "cornell", "povray", -0.0),
            std::filesystem::path("cornell.povray.exr"));
}

}  // namespace
}  // namespace rtb
