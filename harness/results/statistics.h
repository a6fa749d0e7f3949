/// @file
/// Descriptive statistics of samples, in double precision. None of these
/// functions accepts an empty sample.
#pragma once

#include <cstdint>
#include <span>

namespace rtb {

/// Arithmetic mean, added in order.
double Mean(std::span<const double> values);

/// The `percent`-th percentile, percent in [0, 100]: linear interpolation
/// between the order statistics at rank percent / 100 (n - 1), definition 7 of
/// Hyndman and Fan, "Sample Quantiles in Statistical Packages", The American
/// Statistician 50(4), 1996 (also the default of NumPy and R).
double Percentile(std::span<const double> values, double percent);

/// The 50th percentile.
double Median(std::span<const double> values);

/// Sample standard deviation (divided by n - 1) over the mean's magnitude. 0
/// for a single value, or where all are equal.
double CoefficientOfVariation(std::span<const double> values);

/// The bounds of an interval.
struct Interval {
  double lo = 0;
  double hi = 0;

  bool operator==(const Interval&) const = default;
};

/// 95 % percentile-bootstrap interval of the median: the 2.5th and 97.5th
/// percentile of the medians of 10,000 resamples (Efron and Tibshirani, "An
/// Introduction to the Bootstrap", 1993, section 13.3). Deterministic: the
/// same values and seed give the same interval.
Interval BootstrapMedian(std::span<const double> values,
                         std::uint64_t seed = 1);

/// What is reported of repeated timings.
struct Summary {
  double median = 0;
  Interval interval;  ///< 95 % bootstrap interval of the median.
  double p95 = 0;
  double mean = 0;
  double cv = 0;  ///< Coefficient of variation.

  bool operator==(const Summary&) const = default;
};

Summary Summarize(std::span<const double> values);

}  // namespace rtb
