#include "harness/metrics/metric.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/color/srgb.h"
#include "harness/metrics/flip_map.h"
#include "tests/harness/metrics/test_images.h"

namespace rtb {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Image Uniform(int width, int height, float value) {
  Image image(width, height);
  for (Rgb& pixel : image.pixels()) pixel = Rgb(value);
  return image;
}

std::optional<double> Compute(const char* name, const Image& reference,
                              const Image& test) {
  const Metric* metric = FindMetric(name);
  RTB_CHECK(metric != nullptr);
  return metric->compute(MetricInput(reference, test));
}

TEST(MetricsTest, ListsTheNamesOfRecordsInOrder) {
  std::vector<std::string> names;
  for (const Metric& metric : Metrics()) names.emplace_back(metric.name);
  EXPECT_THAT(names,
              ElementsAre("flip", "flip_ppd30", "flip_ppd67", "flip_p95",
                          "hdr_flip", "mse", "psnr", "rmse_linear", "rel_mse",
                          "ssim", "ms_ssim", "ciede2000", "ciede2000_p95"));
}

TEST(MetricsTest, FindsByNameAlone) {
  ASSERT_NE(FindMetric("mse"), nullptr);
  EXPECT_STREQ(FindMetric("mse")->name, "mse");
  EXPECT_EQ(FindMetric("MSE"), nullptr);
  EXPECT_EQ(FindMetric(""), nullptr);
}

TEST(ScoreTest, GivesEveryMetricOnce) {
  const auto values = Score(Uniform(16, 16, 0.25f), Uniform(16, 16, 0.75f));
  ASSERT_TRUE(values.has_value());
  ASSERT_EQ(values->size(), Metrics().size());
  for (std::size_t i = 0; i < values->size(); ++i) {
    EXPECT_EQ((*values)[i].name, Metrics()[i].name);
  }
}

TEST(ScoreTest, RefusesOtherSizes) {
  const auto values = Score(Uniform(4, 3, 0), Uniform(3, 4, 0));
  ASSERT_FALSE(values.has_value());
  EXPECT_EQ(values.error().kind, ErrorKind::kBadInput);
  EXPECT_THAT(values.error().what, HasSubstr("3x4"));
  EXPECT_THAT(values.error().what, HasSubstr("4x3"));
}

TEST(ScoreTest, RefusesEmptyImages) {
  EXPECT_FALSE(Score(Image(), Image()).has_value());
  EXPECT_FALSE(Score(Image(0, 5), Image(0, 5)).has_value());
}

TEST(MetricInputDeathTest, ChecksTheSizes) {
  EXPECT_DEATH(MetricInput(Uniform(2, 1, 0), Uniform(1, 2, 0)), "width");
}

TEST(MetricInputTest, ComputesDerivedThingsOnce) {
  const Image image = Uniform(1, 1, 0);
  const MetricInput input(image, image);
  int calls = 0;
  const auto make = [&] { return ++calls; };
  EXPECT_EQ(input.Once<int>("a", make), 1);
  EXPECT_EQ(input.Once<int>("a", make), 1);
  EXPECT_EQ(input.Once<int>("b", make), 2);
}

// All channels differ by 1/4: the mean square is 1/16, and
// -10 log10(1/16) = 12.0412 dB.
TEST(MseTest, OfAUniformDifference) {
  const Image a = Uniform(5, 3, 0.5f);
  const Image b = Uniform(5, 3, 0.75f);
  EXPECT_DOUBLE_EQ(*Compute("mse", a, b), 0.0625);
  EXPECT_NEAR(*Compute("psnr", a, b), 12.0411998, 1e-6);
}

// One channel of one pixel of four is off by 1: 1 / (4 x 3).
TEST(MseTest, CountsPixelsAndChannels) {
  Image b = Uniform(2, 2, 0);
  b.at(1, 0).y = 1;
  EXPECT_DOUBLE_EQ(*Compute("mse", Uniform(2, 2, 0), b), 1.0 / 12);
}

// sRGB decodes 0.5 to ((0.5 + 0.055) / 1.055)^2.4 = 0.2140411.
TEST(LinearErrorTest, DecodesFirst) {
  const Image black = Uniform(3, 3, 0);
  const Image gray = Uniform(3, 3, 0.5f);
  const double linear = 0.21404114;
  EXPECT_NEAR(*Compute("rmse_linear", black, gray), linear, 1e-7);
  EXPECT_NEAR(*Compute("rel_mse", black, gray), linear * linear / 0.01, 1e-5);
  EXPECT_NEAR(*Compute("rel_mse", gray, black),
              linear * linear / (linear * linear + 0.01), 1e-6);
}

// Without variance, c s = 1 and SSIM is its luminance term:
// (2 a b + 1e-4) / (a^2 + b^2 + 1e-4).
TEST(SsimTest, OfUniformImagesIsTheLuminanceTerm) {
  EXPECT_NEAR(*Compute("ssim", Uniform(11, 11, 0.25f), Uniform(11, 11, 0.5f)),
              (2 * 0.125 + 1e-4) / (0.0625 + 0.25 + 1e-4), 1e-9);
}

TEST(SsimTest, IsUndefinedBelowItsWindow) {
  const Image narrow = Uniform(10, 40, 0.5f);
  EXPECT_FALSE(Compute("ssim", narrow, narrow).has_value());
  const Image least = Uniform(11, 11, 0.5f);
  EXPECT_TRUE(Compute("ssim", least, least).has_value());
}

TEST(MsSsimTest, IsUndefinedBelow176Pixels) {
  const Image narrow = Uniform(175, 300, 0.5f);
  EXPECT_FALSE(Compute("ms_ssim", narrow, narrow).has_value());
  const Image least = Uniform(176, 176, 0.5f);
  EXPECT_NEAR(*Compute("ms_ssim", least, least), 1, 1e-12);
  const Image odd = Uniform(177, 201, 0.5f);
  EXPECT_NEAR(*Compute("ms_ssim", odd, odd), 1, 1e-12);
}

TEST(FlipTest, IsSymmetric) {
  const Image a = Pattern();
  const Image b = Noisy(Blurred(a, 2), 0.1f);
  for (const char* name : {"flip", "flip_ppd30", "flip_ppd67", "flip_p95"}) {
    EXPECT_DOUBLE_EQ(*Compute(name, a, b), *Compute(name, b, a)) << name;
  }
}

// The largest distance that the error range knows is green against blue; its
// color error is 1, and without edges that is FLIP.
TEST(FlipTest, OfGreenAndBlueIsOne) {
  Image green(8, 8);
  Image blue(8, 8);
  for (Rgb& pixel : green.pixels()) pixel = Rgb(0, 1, 0);
  for (Rgb& pixel : blue.pixels()) pixel = Rgb(0, 0, 1);
  EXPECT_NEAR(*Compute("flip", green, blue), 1, 1e-9);
}

// On uniform images the filters do nothing. Gray 0.5 has L* 53.389 and no
// chroma, and 53.389^0.7 = 16.1889. Hunt-adjusted, green is (87.736, -75.610,
// 72.981) and blue (32.298, 25.578, -34.836): HyAB 203.302, to the power of
// 0.7 41.2761, of which the knee is 0.4: 16.5104. So the gray's error lies
// below it: 0.95 x 16.1889 / 16.5104 = 0.931496.
TEST(FlipTest, OfUniformGrayFollowsTheErrorRange) {
  EXPECT_NEAR(*Compute("flip", Uniform(9, 9, 0), Uniform(9, 9, 0.5f)), 0.931496,
              1e-6);
}

TEST(FlipTest, MapHasThePixelsOfTheImages) {
  const Image a = Uniform(7, 5, 0);
  const MetricInput input(a, a);
  const ChannelPlane& map = FlipMap(input, kFlipPpd);
  EXPECT_EQ(map.width(), 7);
  EXPECT_EQ(map.height(), 5);
  EXPECT_EQ(&map, &FlipMap(input, kFlipPpd));
}

}  // namespace
}  // namespace rtb
