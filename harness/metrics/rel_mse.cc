#include "harness/metrics/linear_error.h"

namespace rtb {
namespace {

/// Keeps black from dividing by nothing.
constexpr double kEpsilon = 0.01;

std::optional<double> Compute(const MetricInput& input) {
  return MeanLinearError(input, [](double r, double t) {
    return (t - r) * (t - r) / (r * r + kEpsilon);
  });
}

}  // namespace

Metric RelMseMetric() {
  return {"rel_mse",
          "mean of (t - r)^2 / (r^2 + 0.01) of linear values, t the test and r "
          "the reference",
          true, Compute};
}

}  // namespace rtb
