#include "harness/results/statistics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/base/check.h"
#include "core/math/random.h"

namespace rtb {
namespace {

constexpr std::uint32_t kResamples = 10000;

/// Percentile of values that may be reordered.
double PercentileInPlace(std::vector<double>& values, double percent) {
  RTB_CHECK(!values.empty());
  RTB_CHECK_GE(percent, 0);
  RTB_CHECK_LE(percent, 100);
  const double rank = percent / 100 * static_cast<double>(values.size() - 1);
  const auto below =
      values.begin() + static_cast<std::ptrdiff_t>(std::floor(rank));
  std::nth_element(values.begin(), below, values.end());
  const double fraction = rank - std::floor(rank);
  if (fraction == 0) return *below;
  // Everything behind `below` is at least as large: the next order statistic
  // is the least of it.
  const double above = *std::min_element(below + 1, values.end());
  return *below + fraction * (above - *below);
}

}  // namespace

double Mean(std::span<const double> values) {
  RTB_CHECK(!values.empty());
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double Percentile(std::span<const double> values, double percent) {
  std::vector<double> copy(values.begin(), values.end());
  return PercentileInPlace(copy, percent);
}

double Median(std::span<const double> values) { return Percentile(values, 50); }

double CoefficientOfVariation(std::span<const double> values) {
  const double mean = Mean(values);
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  if (squares == 0) return 0;
  const double variance = squares / static_cast<double>(values.size() - 1);
  return std::sqrt(variance) / std::abs(mean);
}

Interval BootstrapMedian(std::span<const double> values, std::uint64_t seed) {
  RTB_CHECK(!values.empty());
  const auto count = static_cast<std::uint64_t>(values.size());
  std::vector<double> medians;
  std::vector<double> resample(values.size());
  for (std::uint32_t i = 0; i < kResamples; ++i) {
    for (std::uint32_t k = 0; k < resample.size(); ++k) {
      // Multiply and shift: uniform over the indices up to 2^-32.
      const std::uint64_t bits = RandomBits(i, k, 0, seed);
      resample[k] = values[(bits * count) >> 32];
    }
    medians.push_back(PercentileInPlace(resample, 50));
  }
  return {PercentileInPlace(medians, 2.5), PercentileInPlace(medians, 97.5)};
}

Summary Summarize(std::span<const double> values) {
  return {Median(values), BootstrapMedian(values), Percentile(values, 95),
          Mean(values), CoefficientOfVariation(values)};
}

}  // namespace rtb
