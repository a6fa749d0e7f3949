#include "encoders/adaptive/edge_metric.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/math/random.h"

namespace rtb {
namespace {

/// `count` samples at random places in a 24 x 32 window, of a gray that
/// depends on the place.
template <class GrayAt>
NearSamples Scattered(int count, const GrayAt& gray_at) {
  NearSamples near;
  for (int i = 0; i < count; ++i) {
    const auto number = static_cast<std::uint32_t>(i);
    const V2f at(24 * UnitFloat(RandomBits(number, 0, 0, 5)) - 8,
                 32 * UnitFloat(RandomBits(number, 0, 1, 5)) - 8);
    const Rgb gray(gray_at(at));
    near.Add(at, gray, gray);
  }
  return near;
}

/// How far the metric makes a step of one unit in a direction.
float LengthOf(const EdgeMetric& metric, const V2f& step) {
  const V2f unit = step.normalized();
  float x[] = {unit.x};
  float y[] = {unit.y};
  metric.Turn(x, y);
  return V2f(x[0], y[0]).length();
}

// Across an edge a step is sqrt(3) long at most, along it 1 / sqrt(3).
TEST(EdgeMetricTest, StretchesAcrossAnEdge) {
  for (const float angle : {0.0f, 0.6f, 1.2f, 2.0f, 2.9f}) {
    const V2f across(std::cos(angle), std::sin(angle));
    const V2f along(-across.y, across.x);
    const EdgeMetric metric = MetricOf(Scattered(60, [&](const V2f& at) {
      return (at - V2f(4, 8)).dot(across) < 0 ? 0.2f : 0.9f;
    }));
    EXPECT_GT(LengthOf(metric, across), 1.18f) << angle;
    EXPECT_LT(LengthOf(metric, across), 1.74f) << angle;
    EXPECT_LT(LengthOf(metric, along), 0.85f) << angle;
    EXPECT_GT(LengthOf(metric, along), 0.57f) << angle;
    // Areas stay.
    EXPECT_NEAR(metric.xx * metric.yy - metric.xy * metric.xy, 1, 1e-5f);
  }
}

// What is alike keeps its distances: so many squared differences below that
// of an edge say nothing.
TEST(EdgeMetricTest, KeepsDistancesWhereNothingChanges) {
  const EdgeMetric flat =
      MetricOf(Scattered(40, [](const V2f&) { return 0.4f; }));
  EXPECT_NEAR(flat.xx, 1, 1e-4f);
  EXPECT_NEAR(flat.xy, 0, 1e-4f);
  EXPECT_NEAR(flat.yy, 1, 1e-4f);
  const EdgeMetric faint = MetricOf(Scattered(
      40, [](const V2f& at) { return at.x < 4 ? 0.4f : 0.4f + 2.0f / 255; }));
  EXPECT_NEAR(faint.xx, 1, 0.05f);
}

// Noise differs as much one way as any other: what one picture of it seems to
// be stretched by is the next one's chance. The lengths are in 1/sqrt(3) ..
// sqrt(3) and spread by less than 0.4, their means of 100 by 0.04.
TEST(EdgeMetricTest, PrefersNoDirectionInNoise) {
  V2f sum(0);
  float mixed = 0;
  for (std::uint32_t seed = 0; seed < 100; ++seed) {
    std::uint32_t number = 0;
    const EdgeMetric metric = MetricOf(Scattered(60, [&](const V2f&) {
      return UnitFloat(RandomBits(number++, 0, 0, seed));
    }));
    sum += V2f(metric.xx, metric.yy);
    mixed += metric.xy;
  }
  EXPECT_NEAR((sum.x - sum.y) / 100, 0, 0.16f);
  EXPECT_NEAR(mixed / 100, 0, 0.12f);
}

TEST(EdgeMetricTest, FewSamplesKeepDistances) {
  for (int count = 0; count <= 1; ++count) {
    const EdgeMetric metric =
        MetricOf(Scattered(count, [](const V2f&) { return 1.0f; }));
    EXPECT_EQ(metric.xx, 1);
    EXPECT_EQ(metric.xy, 0);
    EXPECT_EQ(metric.yy, 1);
  }
}

// Of hundreds of samples a part is looked at, from everywhere.
TEST(EdgeMetricTest, ManySamplesTellTheSame) {
  const auto halves = [](const V2f& at) { return at.y < 8 ? 0.1f : 0.8f; };
  const EdgeMetric metric = MetricOf(Scattered(900, halves));
  EXPECT_GT(LengthOf(metric, V2f(0, 1)), 1.4f);
}

}  // namespace
}  // namespace rtb
