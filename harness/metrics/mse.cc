#include "harness/metrics/mse.h"

#include "harness/metrics/rows.h"

namespace rtb {
namespace {

std::optional<double> Compute(const MetricInput& input) {
  return MeanSquaredError(input);
}

}  // namespace

double MeanSquaredError(const MetricInput& input) {
  return input.Once<double>("mse", [&] {
    const auto squared = [&](int x, int y) {
      return (V3d(input.test().at(x, y)) - V3d(input.reference().at(x, y)))
          .length2();
    };
    return MeanOverPixels(input.width(), input.height(), input.threads(),
                          squared) /
           3;
  });
}

Metric MseMetric() {
  return {"mse",
          "mean squared error of sRGB-encoded values in [0, 1] over pixels and "
          "channels",
          true, Compute};
}

}  // namespace rtb
