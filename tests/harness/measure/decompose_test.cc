#include "harness/measure/decompose.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/color/srgb.h"
#include "core/image/io.h"
#include "encoders/registry.h"
#include "harness/measure/bound.h"
#include "harness/measure/converged_image.h"
#include "harness/metrics/flip_map.h"
#include "harness/metrics/mse.h"
#include "tests/harness/temporary_folder.h"

namespace rtb {
namespace {

using testing::DoubleNear;
using testing::Optional;

Image Gray(float value) {
  Image image(1, 1);
  image.at(0, 0) = Rgb(value);
  return image;
}

// b = 1/4, s = 1/2, e = -1/8, exactly: T - R = 5/8.
TEST(SplitMseTest, GivesTheSixTerms) {
  const MseTerms terms =
      SplitMse({Gray(0.125f), Gray(0.375f), Gray(0.875f), Gray(0.75f)}, 1);
  EXPECT_DOUBLE_EQ(terms.render, 1.0 / 16);
  EXPECT_DOUBLE_EQ(terms.sampling, 1.0 / 4);
  EXPECT_DOUBLE_EQ(terms.encoding, 1.0 / 64);
  EXPECT_DOUBLE_EQ(terms.render_sampling, 2.0 / 8);
  EXPECT_DOUBLE_EQ(terms.render_encoding, -2.0 / 32);
  EXPECT_DOUBLE_EQ(terms.sampling_encoding, -2.0 / 16);
  EXPECT_DOUBLE_EQ(terms.total, 25.0 / 64);
}

double SumOf(const MseTerms& terms) {
  return terms.render + terms.sampling + terms.encoding +
         terms.render_sampling + terms.render_encoding +
         terms.sampling_encoding;
}

/// A bright ball before a gradient: edges, and tones between codes.
constexpr char kScene[] =
    "rtbench_scene: 1\n"
    "name: ball\n"
    "camera: {position: [0, 0, 0], look_at: [0, 0, -1], vfov: 40}\n"
    "background: {type: gradient, bottom: [0.1, 0.1, 0.3], top: [0.9, 0.5, "
    "0.2]}\n"
    "materials: [{id: m, type: emissive, radiance: [0.9, 0.9, 0.4]}]\n"
    "objects: [{type: sphere, center: [0.3, 0.1, -3], radius: 0.6, material: "
    "m}]\n";

/// An encoder's run on the ball, and all that belongs to its error.
class BallRun {
 public:
  explicit BallRun(const std::string& spec, GridSize grid = {12, 4}) {
    SceneRequest request;
    request.scene = folder_.Write("ball.yaml", kScene).string();
    scene_ = std::move(PrepareScene(request).value());
    encoder_ = MakeEncoder(spec).value();
    SceneSource source = scene_.Source();
    encoding_ = encoder_->Run(source, grid, 0.5, {}).value();
    const PixelSize raster{8 * grid.columns, 16 * grid.rows};
    converged_ =
        DisplayEncoded(ConvergedImage(scene_, 0, raster, "").value(), 0, false);
    reference_ = converged_;
    for (Rgb& pixel : reference_.pixels()) {
      // Another renderer's picture: somewhat darker.
      pixel = EncodedValues(QuantizeEncoded(pixel * 0.95f));
    }
  }

  ErrorInput Input() const {
    return {scene_,     "spec", *encoder_, encoding_, reference_,
            converged_, {},     {},        {}};
  }
  Image Drawn() const { return Decode(encoding_.grid, {}).value(); }
  const Image& reference() const { return reference_; }
  const Encoding& encoding() const { return encoding_; }

 private:
  TemporaryFolder folder_;
  PreparedScene scene_;
  std::unique_ptr<Encoder> encoder_;
  Encoding encoding_;
  Image reference_;
  Image converged_;
};

class DecomposeTest : public testing::TestWithParam<std::string> {};

TEST_P(DecomposeTest, AddsUp) {
  const BallRun run(GetParam());
  const Decomposition parts = Decompose(run.Input()).value();
  const Image drawn = run.Drawn();
  const MetricInput input(run.reference(), drawn);
  EXPECT_NEAR(parts.mse.total, MeanSquaredError(input), 1e-15);
  EXPECT_GT(parts.mse.total, 1e-5);
  EXPECT_NEAR(SumOf(parts.mse), parts.mse.total, 1e-9);
  // 5 % of encoded values of around 0.7.
  EXPECT_NEAR(parts.mse.render, 0.035 * 0.035, 0.02 * 0.02);
  EXPECT_DOUBLE_EQ(parts.flip.reference_grid, MeanFlip(input));
  EXPECT_GT(parts.flip.reference_converged, 0);
  EXPECT_GT(parts.flip.converged_fragments, 0);
  ASSERT_TRUE(parts.inner.has_value());
  EXPECT_NEAR(parts.inner->capacity + parts.inner->masks + parts.inner->colors,
              parts.mse.encoding, 1e-9);
  EXPECT_GE(parts.inner->capacity, 0);
  EXPECT_GT(parts.inner->masks, -1e-9);
  EXPECT_GT(parts.inner->colors, -1e-9);
}

TEST_P(DecomposeTest, NeverBeatsTheBound) {
  const BallRun run(GetParam());
  const auto bound = CompareWithBound(run.Input()).value();
  ASSERT_TRUE(bound.has_value());
  ASSERT_TRUE(bound->gap.has_value());
  EXPECT_GE(*bound->gap, 1 - 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Encoders, DecomposeTest,
                         testing::Values("half", "quadrant", "search", "tiv",
                                         "adaptive", "optimal"),
                         [](const auto& spec) { return spec.param; });

// It sees every pixel and chooses the best glyph for it: no mask is better,
// and colors cost what rounding to 8 bits does, at most half a code.
TEST(DecomposePartsTest, OptimalLosesNothingButRounding) {
  const BallRun run("optimal");
  const InnerTerms inner = SplitEncoding(run.Input()).value();
  const double rounding = 0.25 / (255.0 * 255.0);
  EXPECT_LT(inner.masks + inner.colors, rounding);
  EXPECT_GT(inner.capacity, inner.masks + inner.colors);
}

// `half` sees two samples a cell, which its two colors show exactly but for
// rounding.
TEST(DecomposePartsTest, HalfDrawsAllThatItSees) {
  const BallRun run("half");
  const Decomposition parts = Decompose(run.Input()).value();
  EXPECT_LT(parts.mse.encoding, 0.25 / (255.0 * 255.0));
  EXPECT_GT(parts.mse.sampling, parts.mse.encoding);
  EXPECT_NEAR(parts.inner->capacity, 0, 1e-12);
}

// On the reference as its source an encoder need not find it out first.
TEST(DecomposePartsTest, TheOracleIsCloserThanTheRun) {
  const BallRun run("optimal");
  const FlipDistances flip = Decompose(run.Input())->flip;
  ASSERT_TRUE(flip.oracle.has_value());
  EXPECT_LT(*flip.oracle, flip.reference_grid);
}

// Upper and lower half of a cell are the two samples that `half` takes.
TEST(FragmentsImageTest, ShowsTheNearestSampleOfEachCell) {
  const BallRun run("half", {6, 2});
  const Image image = FragmentsImage(run.encoding(), {});
  ASSERT_EQ(image.width(), 48);
  ASSERT_EQ(image.height(), 32);
  const auto& samples = run.encoding().evidence.rounds[0].fragments;
  const Rgb upper = samples.cell(7)[0];
  const Rgb lower = samples.cell(7)[1];
  EXPECT_NEAR(image.at(8, 16).x, SrgbEncode(upper.x), 1e-6);
  EXPECT_NEAR(image.at(15, 23).x, SrgbEncode(upper.x), 1e-6);
  EXPECT_NEAR(image.at(8, 24).x, SrgbEncode(lower.x), 1e-6);
  EXPECT_NEAR(image.at(15, 31).x, SrgbEncode(lower.x), 1e-6);
}

// A reference of half the size: all steps are reduced to it and still add up;
// the bound, which speaks of cells in two colors, does not.
TEST(DecomposePartsTest, TakesASmallerReference) {
  const BallRun run("quadrant");
  Image small(48, 32);
  for (Rgb& pixel : small.pixels()) pixel = Rgb(0.5f);
  const ErrorInput whole = run.Input();
  const ErrorInput input{whole.scene,
                         whole.spec,
                         whole.encoder,
                         whole.encoding,
                         small,
                         whole.converged,
                         {},
                         {},
                         {}};
  const MseTerms terms = Decompose(input)->mse;
  EXPECT_NEAR(SumOf(terms), terms.total, 1e-9);
  EXPECT_EQ(CompareWithBound(input).value(), std::nullopt);
}

// The full block in DejaVu Sans Mono leaves no gaps that a cell of one color
// would show; a block that it draws otherwise than Unicode defines costs.
TEST(DecomposePartsTest, FontTermIsTheDifferenceOfTheTwoDecodings) {
  const BallRun run("quadrant");
  const Decomposition parts = Decompose(run.Input()).value();
  if (!parts.mse.font) GTEST_SKIP() << "DejaVu Sans Mono is missing";
  DecodeOptions font;
  font.masks = MaskSource::kFont;
  const Image drawn = Decode(run.encoding().grid, font).value();
  const double mse = MeanSquaredError(MetricInput(run.reference(), drawn));
  EXPECT_THAT(parts.mse.font,
              Optional(DoubleNear(mse - parts.mse.total, 1e-15)));
}

}  // namespace
}  // namespace rtb
