/// @file
/// Pearson's chi-square test of counts against what a density predicts.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace rtb {

/// One bin of a histogram.
struct ChiSquareBin {
  double expected = 0;
  double observed = 0;
};

/// The chance that chi-square of k degrees of freedom exceeds x: Wilson and
/// Hilferty, "The Distribution of Chi-Square", PNAS 17(12), 1931. Good to a
/// few percent of the value down to 1e-5 where k is 5 or more.
inline double ChiSquareTail(double x, double k) {
  const double v = 2 / (9 * k);
  const double z = (std::cbrt(x / k) - (1 - v)) / std::sqrt(v);
  return std::erfc(z / std::sqrt(2.0)) / 2;
}

/// Joins bins, those that expect least first, until each expects 5 or more.
inline std::vector<ChiSquareBin> PoolBins(std::vector<ChiSquareBin> bins) {
  std::sort(bins.begin(), bins.end(),
            [](const ChiSquareBin& a, const ChiSquareBin& b) {
              return a.expected < b.expected;
            });
  std::vector<ChiSquareBin> pooled;
  ChiSquareBin pool;
  for (const ChiSquareBin& bin : bins) {
    pool.expected += bin.expected;
    pool.observed += bin.observed;
    if (pool.expected >= 5) {
      pooled.push_back(pool);
      pool = {};
    }
  }
  if (!pooled.empty()) {
    pooled.back().expected += pool.expected;
    pooled.back().observed += pool.observed;
  }
  return pooled;
}

/// The chance of counts at least as far off. The bins hold every sample, so
/// that the expectations add up to their number. 0 where a sample lies in a
/// bin that cannot have any.
inline double ChiSquarePValue(const std::vector<ChiSquareBin>& bins) {
  for (const ChiSquareBin& bin : bins) {
    if (bin.expected <= 0 && bin.observed > 0) return 0;
  }
  double chi_square = 0;
  const std::vector<ChiSquareBin> pooled = PoolBins(bins);
  for (const ChiSquareBin& bin : pooled) {
    const double difference = bin.observed - bin.expected;
    chi_square += difference * difference / bin.expected;
  }
  return ChiSquareTail(chi_square, static_cast<double>(pooled.size()) - 1);
}

/// The p-value below which one of `tests` tests fails, so that the chance of
/// any failing by accident is `significance`: Sidak, JASA 62(318), 1967.
inline double SidakLevel(double significance, int tests) {
  return 1 - std::pow(1 - significance, 1.0 / tests);
}

}  // namespace rtb
