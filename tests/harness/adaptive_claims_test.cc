// What docs/adaptive.md claims of the encoder, on the scenes that render
// fastest, at the canonical size. scripts/adaptive_front measures all scenes.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/image/io.h"
#include "encoders/decode.h"
#include "encoders/registry.h"
#include "harness/metrics/flip_map.h"
#include "harness/metrics/mse.h"
#include "harness/reference_choice.h"
#include "harness/run_encoder.h"

namespace rtb {
namespace {

constexpr GridSize kGrid{120, 40};
constexpr PixelSize kRaster{960, 640};
constexpr char kBasic[] = "glyphs=blocks+quadrants+eighths";
constexpr char kMore[] = "glyphs=blocks+quadrants+eighths+sextants+octants";

/// Answers samples with the nearest pixel of an image.
class PixelSource : public FragmentSource {
 public:
  explicit PixelSource(const Image& display) : display_(display) {}

  Result<Fragments> Query(const SamplePlan& plan) override {
    Fragments fragments(plan);
    for (int entry = 0; entry < plan.entries(); ++entry) {
      for (int i = 0; i < plan.samples_per_cell; ++i) {
        const V2f& at = plan.position(entry, i);
        const int cell = plan.cell(entry);
        const int x = cell % kGrid.columns * 8 + static_cast<int>(at.x * 8);
        const int y = cell / kGrid.columns * 16 + static_cast<int>(at.y * 16);
        fragments.cell(entry)[static_cast<std::size_t>(i)] =
            Decode8(QuantizeEncoded(display_.at(x, y)));
      }
    }
    return fragments;
  }

 private:
  const Image& display_;
};

/// A scene with its reference.
class Contest {
 public:
  explicit Contest(const std::string& name) {
    SceneRequest request;
    request.scene =
        std::string(RTB_TEST_SOURCE_DIR "/scenes/") + name + ".yaml";
    scene_ = PrepareScene(request).value();
  }

  /// POV-Ray's image.
  void UsePovray() {
    reference_ = ChooseReference("povray", scene_, kRaster).value().display;
  }

  /// Our own.
  void Render(int spp) {
    RenderOptions options;
    options.spp = spp;
    const Image image = RenderImage(*scene_.backend, kRaster, options).value();
    reference_ = DisplayEncoded(image, scene_.exposure, true);
  }

  double Mse(const std::string& spec) {
    SceneSource source = scene_.Source();
    return MeanSquaredError(MetricInput(reference_, Shown(spec, source)));
  }

  double Flip(const std::string& spec) {
    SceneSource source = scene_.Source();
    const MetricInput input(reference_, Shown(spec, source));
    const auto values = FlipMap(input, kFlipPpd).values();
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
  }

  /// Of what `optimal` makes of the reference itself.
  double Bound(const std::string& glyphs) {
    PixelSource source(reference_);
    return MeanSquaredError(
        MetricInput(reference_, Shown("optimal:" + glyphs, source)));
  }

 private:
  const Image& Shown(const std::string& spec, FragmentSource& source) {
    const auto encoder = MakeEncoder(spec).value();
    const Encoding encoding = encoder->Run(source, kGrid, 0.5, {}).value();
    shown_ = Decode(encoding.grid, {}).value();
    return shown_;
  }

  PreparedScene scene_;
  Image reference_;
  Image shown_;
};

/// The least of the errors of some encoders.
template <class Measure>
double Least(const std::vector<std::string>& specs, const Measure& measure) {
  double least = 1e9;
  for (const std::string& spec : specs) least = std::min(least, measure(spec));
  return least;
}

const std::vector<std::string> kUpTo16 = {
    "half",    "quadrant", "quadrant:split=best", "sextant", "octant",
    "braille", "search"};

class AdaptiveClaims : public testing::TestWithParam<std::string> {
 protected:
  AdaptiveClaims() : contest_(GetParam()) { contest_.UsePovray(); }

  Contest contest_;
};

TEST_P(AdaptiveClaims, SixRaysBeatAnyPatternOfUpTo32) {
  const auto mse = [this](const std::string& spec) {
    return contest_.Mse(spec);
  };
  EXPECT_LT(mse(std::string("adaptive:rays=6:") + kBasic),
            std::min(Least(kUpTo16, mse), mse("tiv")));
}

TEST_P(AdaptiveClaims, EightRaysComeNearTheBound) {
  EXPECT_LE(contest_.Mse(std::string("adaptive:") + kBasic),
            1.2 * contest_.Bound(kBasic));
  EXPECT_LE(contest_.Mse(std::string("adaptive:") + kMore),
            1.3 * contest_.Bound(kMore));
}

TEST_P(AdaptiveClaims, TwelveRaysComeNearerToTheBound) {
  EXPECT_LE(contest_.Mse(std::string("adaptive:rays=12:") + kMore),
            1.2 * contest_.Bound(kMore));
}

TEST_P(AdaptiveClaims, MediansHaveALowerFlip) {
  const auto flip = [this](const std::string& spec) {
    return contest_.Flip(spec);
  };
  EXPECT_LE(flip(std::string("adaptive:color=median:") + kMore),
            0.95 * Least({"octant", "search", "tiv"}, flip));
}

INSTANTIATE_TEST_SUITE_P(, AdaptiveClaims,
                         testing::Values("whitted", "cornell", "moving",
                                         "lambertian"),
                         [](const auto& test) { return test.param; });

TEST(AdaptiveStress, EightRaysBeatAnyPatternOfUpTo16) {
  Contest contest("stress");
  contest.Render(9);
  const auto mse = [&](const std::string& spec) { return contest.Mse(spec); };
  const double least = Least(kUpTo16, mse);
  EXPECT_LT(mse(std::string("adaptive:") + kBasic), least);
  EXPECT_LT(mse(std::string("adaptive:") + kMore), least);
}

}  // namespace
}  // namespace rtb
