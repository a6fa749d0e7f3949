#include "harness/metrics/flip_map.h"
#include "harness/metrics/rows.h"
#include "harness/results/statistics.h"

namespace rtb {

double MeanFlip(const MetricInput& input, double ppd) {
  const ChannelPlane& map = FlipMap(input, ppd);
  return MeanOverPixels(map.width(), map.height(), input.threads(),
                        [&](int x, int y) { return map.row(y)[x]; });
}

namespace {

template <const double& kPpd>
std::optional<double> Compute(const MetricInput& input) {
  return MeanFlip(input, kPpd);
}

std::optional<double> ComputeP95(const MetricInput& input) {
  return Percentile(FlipMap(input, kFlipPpd).values(), 95);
}

}  // namespace

Metric FlipMetric() {
  return {"flip", "mean LDR-FLIP at 40 pixels per degree, 0 to 1", true,
          Compute<kFlipPpd>};
}

Metric FlipPpd30Metric() {
  return {"flip_ppd30", "mean LDR-FLIP at 30 pixels per degree, 0 to 1", true,
          Compute<kFlipPpdNear>};
}

Metric FlipPpd67Metric() {
  return {"flip_ppd67", "mean LDR-FLIP at 67.02 pixels per degree, 0 to 1",
          true, Compute<kFlipPpdFar>};
}

Metric FlipP95Metric() {
  return {"flip_p95",
          "95th percentile of the LDR-FLIP map at 40 pixels per degree, 0 to 1",
          true, ComputeP95};
}

}  // namespace rtb
