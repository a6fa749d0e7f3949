#include <cmath>

#include "harness/metrics/mse.h"

namespace rtb {
namespace {

std::optional<double> Compute(const MetricInput& input) {
  const double mse = MeanSquaredError(input);
  if (mse == 0) return std::nullopt;
  return -10 * std::log10(mse);
}

}  // namespace

Metric PsnrMetric() {
  return {"psnr",
          "peak signal-to-noise ratio of sRGB-encoded values in dB; undefined "
          "for identical images",
          false, Compute};
}

}  // namespace rtb
