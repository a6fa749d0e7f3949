/// @file
/// Means over the linear values of two images.
#pragma once

#include "harness/metrics/derived.h"
#include "harness/metrics/rows.h"

namespace rtb {

/// Mean over pixels and channels of error(reference value, test value), linear
/// in [0, 1].
template <class Error>
double MeanLinearError(const MetricInput& input, const Error& error) {
  const OfBoth<ColorPlanes>& linear = LinearPlanes(input);
  const auto pixel = [&](int x, int y) {
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      sum += error(linear.reference[c].row(y)[x], linear.test[c].row(y)[x]);
    }
    return sum;
  };
  return MeanOverPixels(input.width(), input.height(), input.threads(), pixel) /
         3;
}

}  // namespace rtb
