/// @file
/// Our path integrator against the committed references by Cycles: a
/// two-sample test, both sides with the noise that two seeds of each show.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "core/base/file.h"
#include "core/image/io.h"
#include "core/image/resample.h"
#include "core/render/backend.h"
#include "core/scene/load.h"
#include "reference/reference.h"

namespace rtb {
namespace {

const std::filesystem::path kRoot = RTB_TEST_SOURCE_DIR;

/// Everything is compared at this size: each pixel is the mean over 8 x 8
/// pixels of the references.
constexpr int kWidth = 120, kHeight = 80;
constexpr int kSpp = 128;

struct Case {
  const char* scene;
  /// Largest systematic difference of a tile's mean, relative to it.
  double tolerance;
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.scene; }

/// Two independent pictures of the same thing, and the rays per pixel of each.
struct Pair {
  std::array<Image, 2> images;
  std::array<double, 2> spp{kSpp, kSpp};
};

/// The rays per pixel that a reference's provenance states.
double SppOf(std::filesystem::path file) {
  const Result<std::string> text = ReadFile(file += ".json");
  EXPECT_TRUE(text.has_value()) << file;
  return text ? nlohmann::json::parse(*text).at("settings").at("spp").get<int>()
              : 1;
}

Pair References(const std::string& scene) {
  Pair pair;
  for (const std::size_t seed : {0u, 1u}) {
    const auto file = ReferencePath(kRoot / "reference", scene, "cycles", 0,
                                    static_cast<int>(seed));
    const Result<Image> image = ReadLinear(file);
    EXPECT_TRUE(image.has_value()) << file;
    if (!image) continue;
    pair.images[seed] = ResizeArea(*image, kWidth, kHeight);
    pair.spp[seed] = SppOf(file);
  }
  return pair;
}

Pair Ours(const std::string& name) {
  Pair pair;
  const auto file = kRoot / "scenes" / (name + ".yaml");
  const Result<Scene> scene = LoadScene(file);
  EXPECT_TRUE(scene.has_value()) << file;
  if (!scene) return pair;
  const auto backend = MakeBackend("embree", *scene).value();
  for (const std::size_t seed : {0u, 1u}) {
    RenderOptions options;
    options.integrator = "path";
    options.spp = kSpp;
    options.seed = seed + 1000;  // whatever seeds the references have
    const Fragments fragments =
        backend->Render(PixelPlan(kWidth, kHeight), options).value();
    pair.images[seed] = Image(kWidth, kHeight);
    std::copy(fragments.values.begin(), fragments.values.end(),
              pair.images[seed].pixels().begin());
  }
  return pair;
}

/// A value and the variance of its error.
struct Estimate {
  double value = 0;
  double variance = 0;
};

/// The mean of all rays at a pixel. Of two pictures X1, X2 with n1, n2 rays
/// the difference squared has the mean s^2 (n1 + n2) / (n1 n2), with s^2 / n
/// the variance of n rays' mean; so that of all rays together is estimated by
/// (X1 - X2)^2 n1 n2 / (n1 + n2)^2.
Estimate At(const Pair& pair, int x, int y, int channel) {
  const double a = pair.images[0].at(x, y)[channel];
  const double b = pair.images[1].at(x, y)[channel];
  const double n = pair.spp[0] + pair.spp[1];
  return {(a * pair.spp[0] + b * pair.spp[1]) / n,
          (a - b) * (a - b) * pair.spp[0] * pair.spp[1] / n / n};
}

/// The sum over a square. Over the 400 pixels of a tile the variance is good
/// to 7 %.
Estimate Sum(const Pair& pair, int x0, int y0, int size, int channel) {
  Estimate sum;
  for (int y = y0; y < y0 + size; ++y) {
    for (int x = x0; x < x0 + size; ++x) {
      const Estimate pixel = At(pair, x, y, channel);
      sum.value += pixel.value;
      sum.variance += pixel.variance;
    }
  }
  return sum;
}

class CyclesAgreementTest : public testing::TestWithParam<Case> {};

/// 24 tiles of three channels: |z| > 4.5 has a chance of 5e-4 among them all
/// (Sidak), under a normal distribution.
TEST_P(CyclesAgreementTest, TilesAndTheWholeHaveTheSameMean) {
  const Pair theirs = References(GetParam().scene);
  if (testing::Test::HasFailure()) return;
  const Pair ours = Ours(GetParam().scene);
  constexpr int kTile = 20;
  for (int channel = 0; channel < 3; ++channel) {
    double our_sum = 0, their_sum = 0;
    for (int y = 0; y < kHeight; y += kTile) {
      for (int x = 0; x < kWidth; x += kTile) {
        const Estimate a = Sum(ours, x, y, kTile, channel);
        const Estimate b = Sum(theirs, x, y, kTile, channel);
        const double noise = 4.5 * std::sqrt(a.variance + b.variance);
        EXPECT_NEAR(a.value, b.value,
                    noise + GetParam().tolerance * b.value + 1e-9)
            << "tile " << x << "," << y << " channel " << channel << " noise "
            << noise;
        our_sum += a.value;
        their_sum += b.value;
      }
    }
    EXPECT_NEAR(our_sum / their_sum, 1, 0.01) << "channel " << channel;
  }
}

// reference/README.md says what is known to differ on metal: the curve of
// Principled's Fresnel, and how the light scattered more than once between the
// microfacets is spread (5.5 % in the red of gold at roughness 1).
INSTANTIATE_TEST_SUITE_P(Scenes, CyclesAgreementTest,
                         testing::Values(Case{"cornell-area", 0.003},
                                         Case{"explore", 0.005},
                                         Case{"shadow", 0.003},
                                         Case{"glass", 0.005},
                                         Case{"metal", 0.06}));

}  // namespace
}  // namespace rtb
