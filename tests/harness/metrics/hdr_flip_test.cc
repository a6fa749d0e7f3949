#include "harness/metrics/hdr_flip.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/color/srgb.h"
#include "core/image/io.h"
#include "harness/results/statistics.h"
#include "tests/harness/metrics/test_images.h"

namespace rtb {
namespace {

using testing::HasSubstr;

/// Narkowicz's fit as he gives it, of a value that his renderer would have
/// multiplied by 0.6.
double Narkowicz(double x) {
  const double y = 0.6 * x;
  return y * (2.51 * y + 0.03) / (y * (2.43 * y + 0.59) + 0.14);
}

/// A gray image of one row.
Image Row(const std::vector<float>& values) {
  Image image(static_cast<int>(values.size()), 1);
  for (int x = 0; x < image.width(); ++x) {
    image.at(x, 0) = Rgb(values[static_cast<std::size_t>(x)]);
  }
  return image;
}

/// Values in [0, 1] as a scene of up to `strongest` times white.
Image Lit(Image image, float strongest = 8) {
  for (Rgb& pixel : image.pixels()) {
    pixel = (pixel * pixel + Rgb(0.001f)) * strongest;
  }
  return image;
}

TEST(HdrFlipTest, ToneCurveIsNarkowiczs) {
  for (const double x : {0.0, 0.01, 0.18, 1.0, 4.0, 1000.0}) {
    EXPECT_NEAR(AcesTone(x), Narkowicz(x), 1e-12) << x;
  }
}

// One luminance: largest and median are toned to 0.85 at the same exposure.
TEST(HdrFlipTest, TonesTheReferenceToItsTarget) {
  const ExposureRange range = FlipExposures(Row({2, 2, 2})).value();
  EXPECT_EQ(range.start, range.stop);
  EXPECT_EQ(range.count, 2);
  EXPECT_NEAR(Narkowicz(2 * std::exp2(range.start)), 0.85, 1e-12);
}

// From the largest luminance 4 to the median 0.3: log2(4 / 0.3) = 3.74 stops,
// rounded up to 4 exposures.
TEST(HdrFlipTest, SpansFromTheLargestToTheMedian) {
  const ExposureRange range = FlipExposures(Row({0, 4, 0.3f, 1, 0.1f})).value();
  EXPECT_NEAR(range.stop - range.start, std::log2(4 / 0.3), 1e-6);
  EXPECT_EQ(range.count, 4);
  EXPECT_NEAR(Narkowicz(4 * std::exp2(range.At(0))), 0.85, 1e-9);
  EXPECT_NEAR(Narkowicz(0.3 * std::exp2(range.At(3))), 0.85, 1e-6);
}

TEST(HdrFlipTest, RefusesWhatIsMostlyBlack) {
  const auto refused = HdrFlip(Row({0, 0, 1}), Row({0, 0, 1}));
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().kind, ErrorKind::kBadInput);
  EXPECT_THAT(refused.error().what, HasSubstr("more than half"));
  EXPECT_TRUE(HdrFlip(Row({0, 0, 1, 1}), Row({0, 0, 1, 1})).has_value());
}

TEST(HdrFlipTest, RefusesOtherSizesAndInfinity) {
  EXPECT_FALSE(HdrFlip(Row({1, 1}), Row({1})).has_value());
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_FALSE(HdrFlip(Row({1, infinity}), Row({1, 1})).has_value());
}

/// The definition, step by step: every exposure is toned, encoded for a
/// display and compared by LDR-FLIP as any two images are; of all maps each
/// pixel's largest error counts.
double ByDefinition(const Image& reference, const Image& test) {
  const ExposureRange range = FlipExposures(reference).value();
  const auto shown = [&](Image image, int i) {
    const double gain = std::exp2(range.At(i));
    for (Rgb& pixel : image.pixels()) {
      for (int c = 0; c < 3; ++c) {
        const double toned = Narkowicz(gain * std::max(0.0f, pixel[c]));
        pixel[c] = SrgbEncode(static_cast<float>(toned));
      }
    }
    return image;
  };
  std::vector<double> worst(reference.pixels().size());
  for (int i = 0; i < range.count; ++i) {
    const Image a = shown(reference, i);
    const Image b = shown(test, i);
    const MetricInput input(a, b);
    const auto map = FlipMap(input, kFlipPpd).values();
    std::ranges::transform(worst, map, worst.begin(),
                           [](double p, double q) { return std::max(p, q); });
  }
  return Mean(worst);
}

TEST(HdrFlipTest, IsTheWorstOfAllExposures) {
  const Image reference = Lit(Pattern());
  const Image test = Lit(Noisy(Pattern(), 0.1f));
  const double flip = HdrFlip(reference, test).value();
  EXPECT_GT(flip, 0.01);
  EXPECT_NEAR(flip, ByDefinition(reference, test), 1e-5);
}

TEST(HdrFlipTest, OfIdenticalImagesIsZero) {
  EXPECT_EQ(HdrFlip(Lit(Pattern()), Lit(Pattern())), 0);
}

// The exposures follow the reference: light four times as strong is compared
// two stops darker.
TEST(HdrFlipTest, DoesNotDependOnTheUnitOfLight) {
  const auto flip = [](float strongest) {
    return HdrFlip(Lit(Pattern(), strongest),
                   Lit(Noisy(Pattern(), 0.1f), strongest))
        .value();
  };
  EXPECT_NEAR(flip(2), flip(8), 1e-9);
}

TEST(HdrFlipTest, WorsensWithNoise) {
  double last = 0;
  for (const float amplitude : {0.05f, 0.1f, 0.2f}) {
    const double flip =
        HdrFlip(Lit(Pattern()), Lit(Noisy(Pattern(), amplitude))).value();
    EXPECT_GT(flip, last);
    last = flip;
  }
}

// The difference hides in the light at one exposure and shows at another.
TEST(HdrFlipTest, SeesWhatOneExposureClips) {
  Image reference(32, 32);
  for (Rgb& pixel : reference.pixels()) pixel = Rgb(0.2f);
  Image test = reference;
  for (int y = 8; y < 24; ++y) {
    for (int x = 8; x < 24; ++x) {
      reference.at(x, y) = Rgb(20);
      test.at(x, y) = Rgb(80);
    }
  }
  const Image a = DisplayEncoded(reference, 0, false);
  const Image b = DisplayEncoded(test, 0, false);
  EXPECT_EQ(MeanFlip(MetricInput(a, b)), 0);
  EXPECT_GT(HdrFlip(reference, test).value(), 0.01);
}

TEST(HdrFlipTest, IsUndefinedForWhatADisplayIsGiven) {
  const Image image = Pattern();
  ASSERT_NE(FindMetric("hdr_flip"), nullptr);
  EXPECT_EQ(FindMetric("hdr_flip")->compute(MetricInput(image, image)),
            std::nullopt);
}

}  // namespace
}  // namespace rtb
