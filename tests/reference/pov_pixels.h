/// @file
/// Scenes rendered by the installed POV-Ray, and expectations on their pixels.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

#include "core/base/process.h"
#include "core/image/io.h"
#include "reference/povray.h"
#include "tests/reference/scene_maker.h"

namespace rtb {

inline constexpr double kPi = std::numbers::pi;

#define SKIP_WITHOUT_POVRAY() \
  if (!FindProgram("povray")) GTEST_SKIP() << "povray is not installed"

/// Where the running test may write.
inline std::filesystem::path OutputOfThisTest() {
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  return std::filesystem::path(testing::TempDir()) /
         (std::string("rtb_") + info->test_suite_name() + "." + info->name()) /
         "out.exr";
}

/// The reference of a scene, width x height, one ray per pixel unless told.
/// @param emitters points that an area light shines from.
inline Image Pixels(const Scene& scene, int width, int height, int spp = 1,
                    int emitters = 89) {
  const auto output = OutputOfThisTest();
  const Status done = RenderPovReference(
      scene, {width, height, spp, 0, output, emitters}, nullptr);
  EXPECT_TRUE(done.has_value()) << done.error().ToString();
  const Result<Image> image = ReadLinear(output);
  EXPECT_TRUE(image.has_value());
  return image.value_or(Image(width, height));
}

/// Unit direction through pixel (x, y) of MakeScene's camera.
inline V3d Direction(const Image& image, int x, int y) {
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

/// Tolerance for half floats, whose relative error is 2^-11 = 4.9e-4.
inline constexpr double kHalf = 6e-4;
/// No value is expected there.
inline const V3d kNoValue(-1);

/// What a white diffuse point at p with normal +y shows under a point light.
inline double UnderPointLight(const V3d& p, const V3d& light) {
  const V3d to_light = light - p;
  return to_light.y / std::pow(to_light.length(), 3) / kPi;
}

/// Shows a checker by itself: emission.
inline Index GlowingChecker(Scene* scene, double size) {
  return AddMaterial(scene, Emissive{}, CheckerTexture{Rgb(1), Rgb(0), size});
}

}  // namespace rtb
