#include <algorithm>
#include <cmath>

#include "harness/metrics/derived.h"
#include "harness/metrics/rows.h"
#include "harness/metrics/structure.h"

namespace rtb {
namespace {

// Wang, Simoncelli and Bovik, "Multi-Scale Structural Similarity for Image
// Quality Assessment", Asilomar 2003, cross-scale calibration; finest first.
constexpr double kWeights[] = {0.0448, 0.2856, 0.3001, 0.2363, 0.1333};
constexpr int kScales = static_cast<int>(std::size(kWeights));

/// The least side that leaves a whole window at the coarsest scale.
constexpr int kMinSide = kSsimWindow << (kScales - 1);

/// Half the size, rounded up: means of 2 x 2 pixels. Beyond an odd side's end
/// the symmetric border repeats the last pixel.
ChannelPlane Halve(const ChannelPlane& in, int threads) {
  ChannelPlane out((in.width() + 1) / 2, (in.height() + 1) / 2);
  ForRows(out.height(), threads, [&](int y) {
    const double* upper = in.row(2 * y);
    const double* lower = in.row(std::min(2 * y + 1, in.height() - 1));
    for (int x = 0; x < out.width(); ++x) {
      const int left = 2 * x;
      const int right = std::min(left + 1, in.width() - 1);
      out.row(y)[x] =
          (upper[left] + upper[right] + lower[left] + lower[right]) / 4;
    }
  });
  return out;
}

/// A mean contrast term may be negative, where a fractional power has no
/// value; it counts as 0, no similarity at all.
double Term(double mean, int scale) {
  return std::pow(std::max(mean, 0.0), kWeights[scale]);
}

std::optional<double> Compute(const MetricInput& input) {
  if (std::min(input.width(), input.height()) < kMinSide) return std::nullopt;
  OfBoth<ChannelPlane> luma = LumaPlanes(input);
  double product = 1;
  for (int scale = 0; scale < kScales - 1; ++scale) {
    product *= Term(
        CompareStructure(luma.reference, luma.test, input.threads()).contrast,
        scale);
    luma = {Halve(luma.reference, input.threads()),
            Halve(luma.test, input.threads())};
  }
  return product *
         Term(CompareStructure(luma.reference, luma.test, input.threads())
                  .similarity,
              kScales - 1);
}

}  // namespace

Metric MsSsimMetric() {
  return {"ms_ssim",
          "multi-scale structural similarity of BT.709 luma (Wang et al. "
          "2003), 1 is equal; undefined under 176 pixels",
          false, Compute};
}

}  // namespace rtb
