#include "encoders/modifiers/median.h"

#include <gtest/gtest.h>

#include <vector>

#include "core/math/random.h"

namespace rtb {
namespace {

double Distances(const std::vector<V3d>& samples,
                 const std::vector<double>& weights, const V3d& point) {
  double sum = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    sum += weights[i] * (samples[i] - point).length();
  }
  return sum;
}

// A sample that outweighs the pull of all others is the median itself: 3 of 5
// at one place.
TEST(GeometricMedian, IsTheSampleThatMostAreAt) {
  const V3d a(0.2, 0.4, 0.6);
  const std::vector<V3d> samples = {a, a, a, V3d(1), V3d(0)};
  const V3d median = GeometricMedian(samples, std::vector<double>(5, 1.0));
  EXPECT_LT((median - a).length(), 1e-6);
}

// An equilateral triangle's is its center (Fermat's point), also when the
// iteration starts elsewhere because a weightless sample stands far off.
TEST(GeometricMedian, OfATriangleIsItsCenter) {
  const std::vector<V3d> samples = {V3d(1, 0, 0), V3d(0, 1, 0), V3d(0, 0, 1),
                                    V3d(9)};
  const std::vector<double> weights = {1, 1, 1, 0};
  EXPECT_LT((GeometricMedian(samples, weights) - V3d(1.0 / 3)).length(), 1e-6);
}

// No step in any direction is better.
TEST(GeometricMedian, IsAMinimum) {
  for (std::uint32_t run = 0; run < 20; ++run) {
    std::vector<V3d> samples;
    std::vector<double> weights;
    for (std::uint32_t i = 0; i < 9; ++i) {
      const auto unit = [&](std::uint32_t d) {
        return double{UnitFloat(RandomBits(run, i, d, 3))};
      };
      samples.emplace_back(unit(0), unit(1), unit(2));
      weights.push_back(unit(3));
    }
    const V3d median = GeometricMedian(samples, weights);
    const double least = Distances(samples, weights, median);
    for (const V3d& way : {V3d(1, 0, 0), V3d(0, 1, 0), V3d(0, 0, 1)}) {
      for (const double step : {-1e-3, 1e-3}) {
        EXPECT_GE(Distances(samples, weights, median + step * way),
                  least - 1e-9);
      }
    }
  }
}

// The left half block over 4 x 1 samples: the outlier on the left (code 255
// beside 10, 10) moves a mean to 92, but no median.
TEST(WithMedianColors, TakesTheMedianOfEachSide) {
  Mask mask(6, 1);
  mask.coverage = {1, 1, 1, 0, 0, 0};
  std::vector<V3d> samples;
  for (const int code : {10, 10, 255, 200, 200, 60}) {
    samples.emplace_back(code / 255.0);
  }
  const Cell cell = WithMedianColors(
      {U'▌', {92, 92, 92}, {}}, MakeFitMask(U'▌', mask), Blend::kSrgb, samples);
  EXPECT_EQ(cell, (Cell{U'▌', {10, 10, 10}, {200, 200, 200}}));
}

// A side that only half-covered samples could tell of keeps its color.
TEST(WithMedianColors, KeepsAColorWithoutSamples) {
  Mask mask(2, 1);
  mask.coverage = {0.5, 0};
  const std::vector<V3d> samples = {V3d(0.5), V3d(0)};
  const Cell cell =
      WithMedianColors({U'▘', {7, 8, 9}, {1, 2, 3}}, MakeFitMask(U'▘', mask),
                       Blend::kSrgb, samples);
  EXPECT_EQ(cell, (Cell{U'▘', {7, 8, 9}, {0, 0, 0}}));
}

}  // namespace
}  // namespace rtb
