#include "core/color/ciede2000.h"

#include "core/color/cielab.h"
#include "harness/metrics/derived.h"
#include "harness/metrics/rows.h"
#include "harness/results/statistics.h"

namespace rtb {
namespace {

V3d LabAt(const ColorPlanes& linear, int x, int y) {
  return LinearToLab(
      {linear[0].row(y)[x], linear[1].row(y)[x], linear[2].row(y)[x]});
}

/// CIEDE2000 of each pixel.
const ChannelPlane& DifferenceMap(const MetricInput& input) {
  return input.Once<ChannelPlane>("ciede2000", [&] {
    const OfBoth<ColorPlanes>& linear = LinearPlanes(input);
    ChannelPlane map(input.width(), input.height());
    ForRows(map.height(), input.threads(), [&](int y) {
      for (int x = 0; x < map.width(); ++x) {
        map.row(y)[x] =
            Ciede2000(LabAt(linear.reference, x, y), LabAt(linear.test, x, y));
      }
    });
    return map;
  });
}

std::optional<double> ComputeMean(const MetricInput& input) {
  const ChannelPlane& map = DifferenceMap(input);
  return MeanOverPixels(map.width(), map.height(), input.threads(),
                        [&](int x, int y) { return map.row(y)[x]; });
}

std::optional<double> ComputeP95(const MetricInput& input) {
  return Percentile(DifferenceMap(input).values(), 95);
}

}  // namespace

Metric Ciede2000Metric() {
  return {"ciede2000", "mean CIEDE2000 color difference over pixels", true,
          ComputeMean};
}

Metric Ciede2000P95Metric() {
  return {"ciede2000_p95",
          "95th percentile of the CIEDE2000 color difference over pixels", true,
          ComputeP95};
}

}  // namespace rtb
