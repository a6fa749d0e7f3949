#include "harness/results/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/math/random.h"

namespace rtb {
namespace {

using Values = std::vector<double>;

TEST(MeanTest, IsTheArithmeticMean) {
  EXPECT_DOUBLE_EQ(Mean(Values{1, 2, 6}), 3);
}

TEST(PercentileTest, InterpolatesBetweenOrderStatistics) {
  const Values values = {40, 10, 30, 20};
  EXPECT_DOUBLE_EQ(Percentile(values, 0), 10);
  EXPECT_DOUBLE_EQ(Percentile(values, 100), 40);
  // Rank 0.5 x 3 = 1.5: halfway between 20 and 30.
  EXPECT_DOUBLE_EQ(Percentile(values, 50), 25);
  // Rank 0.95 x 3 = 2.85: 30 + 0.85 x 10.
  EXPECT_DOUBLE_EQ(Percentile(values, 95), 38.5);
}

TEST(PercentileTest, OfOneValueIsThatValue) {
  EXPECT_DOUBLE_EQ(Percentile(Values{7}, 95), 7);
}

TEST(MedianTest, OddAndEvenCounts) {
  EXPECT_DOUBLE_EQ(Median(Values{5, 1, 3}), 3);
  EXPECT_DOUBLE_EQ(Median(Values{5, 1, 3, 4}), 3.5);
}

TEST(CoefficientOfVariationTest, DividesBySampleSizeLessOne) {
  // Mean 4, squared deviations 4 + 0 + 4, variance 8 / 2, deviation 2.
  EXPECT_DOUBLE_EQ(CoefficientOfVariation(Values{2, 4, 6}), 0.5);
  EXPECT_DOUBLE_EQ(CoefficientOfVariation(Values{-2, -4, -6}), 0.5);
}

TEST(CoefficientOfVariationTest, IsZeroWithoutVariation) {
  EXPECT_EQ(CoefficientOfVariation(Values{3}), 0);
  EXPECT_EQ(CoefficientOfVariation(Values{3, 3}), 0);
  EXPECT_EQ(CoefficientOfVariation(Values{0, 0}), 0);
}

TEST(BootstrapMedianTest, OfEqualValuesIsThatValue) {
  EXPECT_EQ(BootstrapMedian(Values{2, 2, 2}), (Interval{2, 2}));
  EXPECT_EQ(BootstrapMedian(Values{2}), (Interval{2, 2}));
}

TEST(BootstrapMedianTest, IsDeterministic) {
  const Values values = {1, 5, 2, 8, 3, 9, 4, 7, 6, 0};
  EXPECT_EQ(BootstrapMedian(values), BootstrapMedian(values));
}

// The median of a resample of three distinct values is the least of them with
// probability P(at least two draws of it) = 3 (1/9)(2/3) + 1/27 = 7/27 > 2.5 %,
// and the greatest likewise: the interval is the whole range.
TEST(BootstrapMedianTest, OfThreeValuesSpansThem) {
  EXPECT_EQ(BootstrapMedian(Values{3, 1, 2}), (Interval{1, 3}));
}

// The median of 101 resampled values of 0 .. 100 falls below k when at least
// 51 of 101 draws do, each with probability k / 101. The normal approximation
// puts the 2.5 % point where (50.5 - k) / sqrt(101 x 1/4) = 1.96: k = 40.6. The
// discrete medians lie within two of it, and the interval about 50.
TEST(BootstrapMedianTest, AgreesWithTheBinomialInterval) {
  Values values;
  for (int i = 0; i <= 100; ++i) values.push_back(i);
  const Interval interval = BootstrapMedian(values);
  EXPECT_NEAR(interval.lo, 40.6, 2);
  EXPECT_NEAR(interval.hi, 100 - 40.6, 2);
}

// Of 200 samples of 25 uniform numbers, about 95 % of the intervals should
// hold the true median. The percentile bootstrap of a median covers a little
// less or more; the standard error of the count is sqrt(200 x .95 x .05) = 3.
TEST(BootstrapMedianTest, CoversTheMedian) {
  int covered = 0;
  for (std::uint32_t trial = 0; trial < 200; ++trial) {
    Values values;
    for (std::uint32_t i = 0; i < 25; ++i) {
      values.push_back(UnitFloat(RandomBits(trial, i, 0, 42)));
    }
    const Interval interval = BootstrapMedian(values);
    covered += interval.lo <= 0.5 && 0.5 <= interval.hi;
  }
  EXPECT_GE(covered, 180);
  EXPECT_LE(covered, 199);
}

TEST(SummarizeTest, GathersAllFigures) {
  const Values values = {2, 4, 6};
  const Summary summary = Summarize(values);
  EXPECT_DOUBLE_EQ(summary.median, 4);
  EXPECT_EQ(summary.interval, (Interval{2, 6}));
  EXPECT_DOUBLE_EQ(summary.p95, 5.8);
  EXPECT_DOUBLE_EQ(summary.mean, 4);
  EXPECT_DOUBLE_EQ(summary.cv, 0.5);
}

TEST(StatisticsDeathTest, RefusesEmptySamples) {
  EXPECT_DEATH(Mean(Values{}), "empty");
  EXPECT_DEATH(Median(Values{}), "empty");
  EXPECT_DEATH(BootstrapMedian(Values{}), "empty");
}

}  // namespace
}  // namespace rtb
