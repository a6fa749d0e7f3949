/// @file
/// The expressions that the exporter relies on, each against its formula in
/// pixels that the installed Blender renders. Pixels are half floats: relative
/// error 2^-11 = 4.9e-4; what Cycles samples at random has noise besides.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/file.h"
#include "core/base/process.h"
#include "core/image/io.h"
#include "reference/cycles.h"
#include "tests/reference/pov_pixels.h"

namespace rtb {
namespace {

/// What the test needs to run, and a scene of a floor one unit below the eye.
class CyclesRenderTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!FindProgram("blender")) GTEST_SKIP() << "blender is not installed";
  }

  static Scene FloorScene() {
    Scene scene = MakeScene();
    scene.settings.max_depth = 0;
    AddObject(&scene, Plane{V3d(0, -1, 0), V3d(0, 1, 0)},
              AddMaterial(&scene, Lambertian{Rgb(0.5f)}));
    return scene;
  }

  static Image Render(const Scene& scene, int width, int height, int spp,
                      const std::string& integrator = "path") {
    ReferenceRequest request;
    request.width = width;
    request.height = height;
    request.spp = spp;
    request.output = OutputOfThisTest();
    request.integrator = integrator;
    request.pixel_centers = true;
    const Status done = RenderCyclesReference(scene, request, nullptr);
    EXPECT_TRUE(done.has_value()) << done.error().ToString();
    const Result<Image> image = ReadLinear(request.output);
    EXPECT_TRUE(image.has_value());
    return image.value_or(Image(width, height));
  }

  /// Expects what a floor shows: `white(p)` times its albedo, each channel
  /// times `color`, by less than `tolerance` on the mean over the floor.
  template <class Function>
  static void ExpectFloor(const Image& image, const V3d& color,
                          double tolerance, const Function& white) {
    V3d sum(0), expected(0);
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        const V3d d = Direction(image, x, y);
        if (d.y >= -0.1) continue;
        sum += V3d(image.at(x, y));
        expected += color * (0.5 * white(d / -d.y));
      }
    }
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(sum[i] / expected[i], 1, tolerance) << "channel " << i;
    }
  }
};

TEST_F(CyclesRenderTest, PointLightWithAndWithoutFalloff) {
  Scene scene = FloorScene();
  const V3d light(1, 1, -3);
  AddLight(&scene, PointLight{light, Rgb(10, 20, 30), true});
  AddLight(&scene, PointLight{light, Rgb(1, 2, 3), false});
  const auto white = [&](const V3d& p) {
    const double d2 = (light - p).length2();
    return UnderPointLight(p, light) * (1 + d2 / 10);
  };
  const Image image = Render(scene, 48, 32, 4);
  ExpectFloor(image, V3d(10, 20, 30), 1e-3, white);
}

TEST_F(CyclesRenderTest, SpotFadesBySmoothstepInTheAngle) {
  Scene scene = FloorScene();
  const V3d light(1, 1, -3), axis = V3d(0.2, -1, -0.3).normalized();
  AddLight(&scene, SpotLight{light, axis * 3, Rgb(10, 20, 30), 20, 25});
  const auto white = [&](const V3d& p) {
    const V3d way = (p - light).normalized();
    const double angle = std::acos(way.dot(axis)) * 180 / kPi;
    const double t = std::clamp((angle - 20) / 25, 0.0, 1.0);
    return UnderPointLight(p, light) * (1 - t * t * (3 - 2 * t));
  };
  ExpectFloor(Render(scene, 48, 32, 4), V3d(10, 20, 30), 2e-3, white);
}

/// Irradiance of a polygon of radiance 1 seen from p with normal +y: Lambert,
/// "Photometria", 1760; half the sum of the edges' angles times their cosines.
double UnderPolygon(const V3d& p, const std::vector<V3d>& corners) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const V3d a = (corners[i] - p).normalized();
    const V3d b = (corners[(i + 1) % corners.size()] - p).normalized();
    sum += std::acos(a.dot(b)) * a.cross(b).normalized().y;
  }
  return std::abs(sum) / 2;
}

// At this size Cycles' own sampling would lose 0.25 %.
TEST_F(CyclesRenderTest, QuadLightOnItsFrontAlone) {
  Scene scene = FloorScene();
  const V3d corner(-1, 1, -4), e0(2, 0, 0), e1(0, 0, 2);
  AddLight(&scene, QuadLight{corner, {e0, e1}, Rgb(5, 6, 7), 1});
  const std::vector<V3d> corners = {corner, corner + e0, corner + e0 + e1,
                                    corner + e1};
  const Image image = Render(scene, 48, 32, 256);
  ExpectFloor(image, V3d(5, 6, 7), 1e-3,
              [&](const V3d& p) { return UnderPolygon(p, corners) / kPi; });
  // Above the eye the panel is seen at (0, 1, -3): y = 1/3 of the half height.
  EXPECT_EQ(image.at(24, 10), Rgb(5, 6, 7));
  auto& panel = std::get<QuadLight>(scene.lights[0].kind);
  std::swap(panel.edges[0], panel.edges[1]);
  const Image back = Render(scene, 48, 32, 4);
  EXPECT_EQ(back.at(24, 10), Rgb(0));
  EXPECT_EQ(back.at(24, 28), Rgb(0));
}

TEST_F(CyclesRenderTest, SphereLight) {
  Scene scene = FloorScene();
  const V3d center(1, 1, -3);
  AddLight(&scene, SphereLight{center, 0.5, Rgb(5, 6, 7), 1});
  // All of it above the floor: pi L (r / d)^2 cos / pi, as a point light of
  // intensity pi r^2 L.
  ExpectFloor(
      Render(scene, 48, 32, 256), V3d(5, 6, 7), 2e-3,
      [&](const V3d& p) { return kPi * 0.25 * UnderPointLight(p, center); });
}

TEST_F(CyclesRenderTest, DepthEndsInBlack) {
  Scene scene = MakeScene();
  scene.background.kind = ConstantBackground{Rgb(1)};
  AddObject(&scene, Sphere{V3d(0, 0, -3), 1},
            AddMaterial(&scene, Dielectric{1.5, Rgb(1)}));
  // At the middle F = 0.04: reflected, straight through, once around inside.
  const std::vector<double> expected = {0, 0.04, 0.04 + 0.96 * 0.96,
                                        0.04 + 0.96 * 0.96 * 1.04};
  for (int depth = 0; depth < 4; ++depth) {
    scene.settings.max_depth = depth;
    const Image image = Render(scene, 9, 9, 512);
    EXPECT_NEAR(image.at(4, 4).x, expected[static_cast<std::size_t>(depth)],
                0.02)
        << depth;
    EXPECT_EQ(image.at(0, 0), Rgb(1));
  }
}

TEST_F(CyclesRenderTest, WhiteUnderAUniformSkyIsTheSky) {
  Scene scene = MakeScene();
  scene.background.kind = ConstantBackground{Rgb(2)};
  AddObject(&scene, Sphere{V3d(0, 0, -3), 1},
            AddMaterial(&scene, Lambertian{Rgb(1)}));
  scene.settings.max_depth = 0;
  const Image image = Render(scene, 12, 8, 256);
  for (const Rgb& pixel : image.pixels()) EXPECT_NEAR(pixel.x, 2, 0.01);
}

TEST_F(CyclesRenderTest, WhittedGlassLetsTintedLightThrough) {
  Scene scene = FloorScene();
  AddObject(&scene, Box{V3d(-99, 2, -99), V3d(99, 3, 99)},
            AddMaterial(&scene, Dielectric{1.5, Rgb(0.9f, 0.5f, 0.2f)}));
  const V3d light(1, 9, -3);
  AddLight(&scene, PointLight{light, Rgb(1000), true});
  ExpectFloor(Render(scene, 48, 32, 4, "whitted"), V3d(810, 250, 40), 1e-3,
              [&](const V3d& p) { return UnderPointLight(p, light); });
}

TEST_F(CyclesRenderTest, ShearedObjectsKeepTheirShape) {
  // A glowing unit square, turned by 45 degrees and then flattened to half its
  // height: corners (0, +-0.3535) and (+-0.7071, 0) at distance 1.
  Scene scene = MakeScene();
  Object square;
  square.shape = Quad{V3d(-0.5, -0.5, 0), {V3d(1, 0, 0), V3d(0, 1, 0)}};
  square.rotate = V3d(0, 0, 45);
  square.material = AddMaterial(&scene, Emissive{Rgb(1)});
  Object& group = AddObject(&scene, Group{});
  group.scale = V3d(1, 0.5, 1);
  group.position = V3d(0, 0, -1);
  group.children.push_back(square);
  const Image image = Render(scene, 64, 64, 4);
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      const V3d d = Direction(image, x, y);
      const double p = std::abs(d.x / d.z), q = std::abs(d.y / d.z);
      const double inside = p / std::sqrt(0.5) + q / std::sqrt(0.125);
      if (std::abs(inside - 1) < 0.02) continue;
      EXPECT_EQ(image.at(x, y).x, inside < 1 ? 1 : 0) << x << "," << y;
    }
  }
}

TEST_F(CyclesRenderTest, WritesProvenanceAndCleansUp) {
  Scene scene = MakeScene();
  scene.sha256 = "abc";
  ReferenceRequest request;
  request.width = 12;
  request.height = 8;
  request.spp = 65;
  request.seed = 3;
  request.output = OutputOfThisTest();
  std::vector<double> shares;
  const Status done = RenderCyclesReference(
      scene, request,
      [&](double share, const std::string&) { shares.push_back(share); });
  ASSERT_TRUE(done.has_value()) << done.error().ToString();
  EXPECT_EQ(shares, (std::vector<double>{0, 0.5, 1}));
  EXPECT_FALSE(std::filesystem::exists(request.output.string() + ".work"));
  const Result<std::string> text = ReadFile(request.output.string() + ".json");
  ASSERT_TRUE(text.has_value());
  const auto json = nlohmann::json::parse(*text);
  EXPECT_EQ(json["renderer"], "cycles");
  EXPECT_THAT(json["version"].get<std::string>(),
              testing::StartsWith("Blender "));
  EXPECT_EQ(json["scene"]["sha256"], "abc");
  EXPECT_EQ(json["settings"]["seed"], 3);
  EXPECT_EQ(json["passes"], 2);
  EXPECT_EQ(json["image"]["sha256"], *Sha256File(request.output));
}

}  // namespace
}  // namespace rtb
