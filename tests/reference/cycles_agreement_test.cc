/// @file
/// Our path integrator against the committed references by Cycles: a
/// two-sample test, both sides with the noise that two seeds of each show.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>

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
constexpr int kSpp = 256;

struct Case {
  const char* scene;
  /// Largest systematic difference of a tile's mean, relative to it.
  double tolerance;
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.scene; }

/// Two independent pictures of the same thing.
using Pair = std::array<Image, 2>;

Pair References(const std::string& scene) {
  Pair pair;
  for (int seed = 0; seed < 2; ++seed) {
    const auto file =
        ReferencePath(kRoot / "reference", scene, "cycles", 0, seed);
    const Result<Image> image = ReadLinear(file);
    EXPECT_TRUE(image.has_value()) << file;
    if (image)
      pair.at(static_cast<std::size_t>(seed)) =
          ResizeArea(*image, kWidth, kHeight);
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
  for (std::uint64_t seed = 0; seed < 2; ++seed) {
    RenderOptions options;
    options.integrator = "path";
    options.spp = kSpp;
    options.seed = seed + 1000;  // whatever seeds the references have
    const Fragments fragments =
        backend->Render(PixelPlan(kWidth, kHeight), options).value();
    pair[seed] = Image(kWidth, kHeight);
    std::copy(fragments.values.begin(), fragments.values.end(),
              pair[seed].pixels().begin());
  }
  return pair;
}

/// Sums over a tile of one channel.
struct Tile {
  double ours = 0, theirs = 0;  ///< Means of the two seeds.
  double variance = 0;          ///< Of the difference of these sums.
};

/// With pictures X1, X2 the mean's variance is estimated by (X1 - X2)^2 / 4
/// at every pixel; over the 400 pixels of a tile that is good to 7 %.
Tile Sum(const Pair& ours, const Pair& theirs, int x0, int y0, int size,
         int channel) {
  Tile tile;
  for (int y = y0; y < y0 + size; ++y) {
    for (int x = x0; x < x0 + size; ++x) {
      const double a0 = ours[0].at(x, y)[channel];
      const double a1 = ours[1].at(x, y)[channel];
      const double b0 = theirs[0].at(x, y)[channel];
      const double b1 = theirs[1].at(x, y)[channel];
      tile.ours += (a0 + a1) / 2;
      tile.theirs += (b0 + b1) / 2;
      tile.variance += ((a0 - a1) * (a0 - a1) + (b0 - b1) * (b0 - b1)) / 4;
    }
  }
  return tile;
}

class CyclesAgreementTest : public testing::TestWithParam<Case> {};

/// 24 tiles of three channels: |z| > 4.5 has a chance of 5e-4 among them all
/// (Sidak), under a normal distribution.
TEST_P(CyclesAgreementTest, TilesHaveTheSameMean) {
  const Pair ours = Ours(GetParam().scene);
  const Pair theirs = References(GetParam().scene);
  if (testing::Test::HasFailure()) return;
  constexpr int kTile = 20;
  for (int y = 0; y < kHeight; y += kTile) {
    for (int x = 0; x < kWidth; x += kTile) {
      for (int channel = 0; channel < 3; ++channel) {
        const Tile t = Sum(ours, theirs, x, y, kTile, channel);
        const double noise = 4.5 * std::sqrt(t.variance);
        EXPECT_NEAR(t.ours, t.theirs,
                    noise + GetParam().tolerance * t.theirs + 1e-9)
            << "tile " << x << "," << y << " channel " << channel << " noise "
            << noise;
      }
    }
  }
}

TEST_P(CyclesAgreementTest, TheWholeImageHasTheSameMeanWithinOnePercent) {
  const Pair ours = Ours(GetParam().scene);
  const Pair theirs = References(GetParam().scene);
  if (testing::Test::HasFailure()) return;
  for (int channel = 0; channel < 3; ++channel) {
    Tile sum;
    for (int x = 0; x < kWidth; x += kHeight / 2) {
      for (int y = 0; y < kHeight; y += kHeight / 2) {
        const Tile t = Sum(ours, theirs, x, y, kHeight / 2, channel);
        sum.ours += t.ours;
        sum.theirs += t.theirs;
      }
    }
    EXPECT_NEAR(sum.ours / sum.theirs, 1, 0.01) << "channel " << channel;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, CyclesAgreementTest,
                         testing::Values(Case{"cornell-area", 0.003},
                                         Case{"shadow", 0.003},
                                         Case{"metal", 0.02},
                                         Case{"glass", 0.005}));

}  // namespace
}  // namespace rtb
