/// @file
/// Choosing among weighted things: cumulative distributions, built on the host
/// and sampled on host and device.
#pragma once

#include <span>
#include <vector>

#include "core/base/host_device.h"

namespace rtb {

/// Writes the cumulative distribution of n weights, n + 1 numbers from 0 to
/// exactly 1. Where no weight is positive every entry is equally likely.
/// @param weights at least one, finite and not negative.
/// @return the sum of the weights.
double FillCdf(std::span<const double> weights, std::span<float> cdf);

/// The same as an array of its own.
std::vector<float> MakeCdf(std::span<const double> weights);

/// What was chosen.
struct DiscreteSample {
  int index = 0;
  float probability = 0;  ///< Of that entry; positive.
  float fraction = 0;     ///< Uniform in [0, 1) again: u within the entry.
};

/// The probability that SampleDiscrete chooses entry `index`, exactly.
RTB_HD inline float DiscreteProbability(const float* cdf, int index) {
  return cdf[index + 1] - cdf[index];
}

/// Chooses entry i with cdf[i] <= u < cdf[i + 1]: never one of probability 0.
/// @param cdf `size` + 1 numbers; @param u in [0, 1).
RTB_HD inline DiscreteSample SampleDiscrete(const float* cdf, int size,
                                            float u) {
  int low = 0;
  int high = size;  // cdf[low] <= u < cdf[high]
  while (high - low > 1) {
    const int middle = low + (high - low) / 2;
    (cdf[middle] <= u ? low : high) = middle;
  }
  const float probability = DiscreteProbability(cdf, low);
  const float fraction = (u - cdf[low]) / probability;
  return {low, probability, fraction < 1 ? fraction : 0x1.fffffep-1f};
}

}  // namespace rtb
