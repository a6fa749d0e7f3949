#include <cmath>

#include "harness/metrics/linear_error.h"

namespace rtb {
namespace {

std::optional<double> Compute(const MetricInput& input) {
  return std::sqrt(MeanLinearError(
      input, [](double r, double t) { return (t - r) * (t - r); }));
}

}  // namespace

Metric RmseLinearMetric() {
  return {"rmse_linear", "root mean squared error of linear values in [0, 1]",
          true, Compute};
}

}  // namespace rtb
