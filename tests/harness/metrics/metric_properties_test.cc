// What must hold for every metric, whatever the images.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include "harness/metrics/metric.h"
#include "tests/harness/metrics/test_images.h"

namespace rtb {

void PrintTo(const Metric& metric, std::ostream* out) { *out << metric.name; }

namespace {

bool IsFlip(const Metric& metric) {
  return std::string(metric.name).rfind("flip", 0) == 0;
}

double Compute(const Metric& metric, const Image& reference,
               const Image& test) {
  const auto value = metric.compute(MetricInput(reference, test));
  return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

class EveryMetric : public testing::TestWithParam<Metric> {
 protected:
  /// The metric gets strictly worse along the tests.
  void ExpectWorsens(const Image& reference,
                     const std::function<Image(int)>& distort) {
    double last = Compute(GetParam(), reference, distort(1));
    ASSERT_FALSE(std::isnan(last));
    for (int step = 2; step <= 4; ++step) {
      const double value = Compute(GetParam(), reference, distort(step));
      if (GetParam().lower_is_better) {
        EXPECT_GT(value, last) << "step " << step;
      } else {
        EXPECT_LT(value, last) << "step " << step;
      }
      last = value;
    }
  }

  /// Applying `turn` to both images changes nothing but rounding.
  void ExpectInvariant(const std::function<Image(const Image&)>& turn) {
    const Image reference = Pattern();
    const Image test = Noisy(Blurred(reference, 2), 0.1f);
    const double tolerance = IsFlip(GetParam()) ? 1e-5 : 1e-9;
    EXPECT_NEAR(Compute(GetParam(), turn(reference), turn(test)),
                Compute(GetParam(), reference, test), tolerance);
  }
};

TEST_P(EveryMetric, OfIdenticalImagesIsZeroNullOrOne) {
  const Image image = Pattern();
  const auto value = GetParam().compute(MetricInput(image, image));
  if (std::string(GetParam().name) == "psnr") {
    EXPECT_FALSE(value.has_value());
  } else {
    ASSERT_TRUE(value.has_value());
    EXPECT_DOUBLE_EQ(*value, GetParam().lower_is_better ? 0 : 1);
  }
}

TEST_P(EveryMetric, WorsensWithBlur) {
  const Image image = Pattern();
  ExpectWorsens(image, [&](int step) { return Blurred(image, 2 * step); });
}

TEST_P(EveryMetric, WorsensWithNoise) {
  const Image image = Pattern();
  ExpectWorsens(image, [&](int step) {
    return Noisy(image, 0.05f * static_cast<float>(step));
  });
}

TEST_P(EveryMetric, IgnoresMirroring) {
  ExpectInvariant(MirroredX);
  ExpectInvariant(MirroredY);
}

TEST_P(EveryMetric, IgnoresRotation) {
  ExpectInvariant(
      [](const Image& image) { return MirroredX(Transposed(image)); });
}

TEST_P(EveryMetric, DoesNotDependOnThreads) {
  const Image reference = Pattern();
  const Image test = Noisy(reference, 0.1f);
  const auto one = GetParam().compute(MetricInput(reference, test, 1));
  EXPECT_EQ(GetParam().compute(MetricInput(reference, test, 2)), one);
  EXPECT_EQ(GetParam().compute(MetricInput(reference, test, 3)), one);
}

TEST_P(EveryMetric, SurvivesOnePixel) {
  Image black(1, 1);
  Image gray(1, 1);
  gray.at(0, 0) = Rgb(0.5f);
  const auto value = GetParam().compute(MetricInput(black, gray));
  const bool needs_window = std::string(GetParam().name).ends_with("ssim");
  ASSERT_EQ(value.has_value(), !needs_window);
  EXPECT_TRUE(std::isfinite(value.value_or(0)));
}

/// HDR-FLIP is undefined for what a display is given: hdr_flip_test.cc.
std::vector<Metric> DefinedMetrics() {
  std::vector<Metric> metrics(Metrics().begin(), Metrics().end());
  std::erase_if(metrics, [](const Metric& metric) {
    return std::string(metric.name) == "hdr_flip";
  });
  return metrics;
}

INSTANTIATE_TEST_SUITE_P(Metrics, EveryMetric,
                         testing::ValuesIn(DefinedMetrics()),
                         [](const auto& metric) { return metric.param.name; });

}  // namespace
}  // namespace rtb
