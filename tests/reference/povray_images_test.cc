// Renders of the whitted integrator against what POV-Ray made of the exported
// scenes: one center ray per pixel, in linear light. The images and the
// commands that made them are in tests/data/povray.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "core/image/io.h"
#include "core/render/backend.h"
#include "core/scene/load.h"

namespace rtb {
namespace {

const std::filesystem::path kRoot = RTB_TEST_SOURCE_DIR;

/// A scene and how far its render may be from POV-Ray's.
struct Case {
  std::string name;
  std::string scene;  ///< Below the repository's root.
  double time;
  double over_thousandth;  ///< Share of pixels off by more than 1e-3.
  double over_hundredth;   ///< Share of pixels off by more than 1e-2.
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

Image RenderLikePovRay(const Case& c, int width, int height) {
  const Scene scene = LoadScene(kRoot / c.scene).value();
  auto backend = MakeBackend("embree", scene).value();
  RenderOptions options;
  options.time = c.time;
  const Fragments f =
      backend->Render(PixelPlan(width, height), options).value();
  Image image(width, height);
  std::copy(f.values.begin(), f.values.end(), image.pixels().begin());
  return image;
}

/// How two images differ, pixel by pixel.
struct Difference {
  double median;  ///< Of the absolute difference over all components.
  double over_thousandth;
  double over_hundredth;
};

Difference Compare(const Image& a, const Image& b) {
  std::vector<float> all;
  double thousandth = 0, hundredth = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    const Rgb d = a.pixels()[i] - b.pixels()[i];
    const float largest =
        std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    for (int c = 0; c < 3; ++c) all.push_back(std::abs(d[c]));
    thousandth += largest > 1e-3f;
    hundredth += largest > 1e-2f;
  }
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
  std::nth_element(all.begin(), middle, all.end());
  const auto pixels = static_cast<double>(a.pixels().size());
  return {*middle, thousandth / pixels, hundredth / pixels};
}

class PovRayImageTest : public ::testing::TestWithParam<Case> {};

TEST_P(PovRayImageTest, RenderEqualsPovRays) {
  const Case& c = GetParam();
  const Image expected =
      ReadLinear(kRoot / "tests/data/povray" / (c.name + ".povray.exr"))
          .value();
  const Image actual = RenderLikePovRay(c, expected.width(), expected.height());
  const Difference d = Compare(actual, expected);
  // The EXR is half float: its rounding alone is up to 4.9e-4 of a value.
  EXPECT_LT(d.median, 3e-4);
  EXPECT_LE(d.over_thousandth, c.over_thousandth);
  EXPECT_LE(d.over_hundredth, c.over_hundredth);
  RecordProperty("median", std::to_string(d.median));
  std::printf("%s: median %.2g, %.4f %% over 1e-3, %.4f %% over 1e-2\n",
              c.name.c_str(), d.median, 100 * d.over_thousandth,
              100 * d.over_hundredth);
}

// What may differ: pixels whose ray passes within float rounding of an edge,
// of a far checker's border or of a shadow's.
INSTANTIATE_TEST_SUITE_P(
    Scenes, PovRayImageTest,
    ::testing::Values(Case{"whitted", "scenes/whitted.yaml", 0, 0.008, 0.003},
                      Case{"cornell", "scenes/cornell.yaml", 0, 0.002, 0.0006},
                      Case{"transforms", "tests/data/scenes/transforms.yaml",
                           1.3, 0.002, 0.001},
                      Case{"materials", "tests/data/scenes/materials.yaml", 1.3,
                           0.002, 0.001},
                      Case{"moving", "tests/data/scenes/moving.yaml", 1.3,
                           0.001, 0.0006}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace rtb
