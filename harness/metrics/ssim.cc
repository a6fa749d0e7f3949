#include <algorithm>

#include "harness/metrics/derived.h"
#include "harness/metrics/structure.h"

namespace rtb {
namespace {

std::optional<double> Compute(const MetricInput& input) {
  if (std::min(input.width(), input.height()) < kSsimWindow) {
    return std::nullopt;
  }
  const OfBoth<ChannelPlane>& luma = LumaPlanes(input);
  return CompareStructure(luma.reference, luma.test, input.threads())
      .similarity;
}

}  // namespace

Metric SsimMetric() {
  return {"ssim",
          "structural similarity of BT.709 luma (Wang et al. 2004), 1 is "
          "equal; undefined under 11 pixels",
          false, Compute};
}

}  // namespace rtb
