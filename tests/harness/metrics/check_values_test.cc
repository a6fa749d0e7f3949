// Every metric against the figures of the official tools: tests/data/metrics.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <ostream>

#include "harness/metrics/metric.h"
#include "tests/harness/metrics/test_images.h"

namespace rtb {
namespace {

nlohmann::json ExpectedPairs() {
  std::ifstream in(std::string(RTB_TEST_SOURCE_DIR) +
                   "/tests/data/metrics/expected.json");
  return nlohmann::json::parse(in).at("pairs");
}

struct CheckValue {
  const char* metric;
  const char* key;  ///< In expected.json.
  double tolerance;
  bool relative;
};

constexpr CheckValue kCheckValues[] = {
    {"flip", "flip_mean_ppd40", 1e-4, false},
    {"flip_ppd30", "flip_mean_ppd30", 1e-4, false},
    {"flip_ppd67", "flip_mean_ppd67_02", 1e-4, false},
    {"mse", "mse_srgb", 1e-6, true},
    {"psnr", "psnr_srgb_db", 1e-3, false},
    {"rmse_linear", "rmse_linear", 1e-5, true},
    {"rel_mse", "relmse_linear_eps0.01", 1e-5, true},
    {"ssim", "ssim_luma709", 1e-5, false},
    {"ms_ssim", "msssim_luma709", 1e-5, false},
    {"ciede2000", "ciede2000_mean", 2e-3, false}};

class CheckValuesTest : public testing::TestWithParam<const char*> {};

TEST_P(CheckValuesTest, AgreesWithOfficialTools) {
  const Image reference = MetricImage("spheres");
  const Image test = MetricImage(GetParam());
  const MetricInput input(reference, test);
  const nlohmann::json expected = ExpectedPairs().at(GetParam());
  for (const CheckValue& check : kCheckValues) {
    const Metric* metric = FindMetric(check.metric);
    ASSERT_NE(metric, nullptr) << check.metric;
    const auto value = metric->compute(input);
    ASSERT_TRUE(value.has_value()) << check.metric;
    const double want = expected.at(check.key).get<double>();
    EXPECT_NEAR(*value, want,
                check.tolerance * (check.relative ? std::abs(want) : 1))
        << check.metric;
  }
}

INSTANTIATE_TEST_SUITE_P(Pairs, CheckValuesTest,
                         testing::Values("blur", "noise", "shift", "bright",
                                         "mosaic"),
                         [](const auto& pair) { return pair.param; });

}  // namespace
}  // namespace rtb
