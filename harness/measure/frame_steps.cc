#include "harness/measure/frame_steps.h"

#include <cmath>

#include "core/base/check.h"
#include "harness/cell_difference.h"
#include "harness/metrics/flip_map.h"
#include "harness/metrics/mse.h"
#include "harness/metrics/rows.h"

namespace rtb {

double ChangedCells(const CellGrid& a, const CellGrid& b) {
  const auto difference = CompareCells(a, b);
  RTB_CHECK(difference.has_value());
  return static_cast<double>(difference->cells) / difference->total;
}

double RmsDifference(const Image& a, const Image& b, int threads) {
  return std::sqrt(MeanSquaredError(MetricInput(a, b, threads)));
}

double TemporalDifferenceError(const Frame& now, const Frame& before,
                               int threads) {
  return MeanOverPixels(
             now.drawn.width(), now.drawn.height(), threads,
             [&](int x, int y) {
               const V3d drawn =
                   V3d(now.drawn.at(x, y)) - V3d(before.drawn.at(x, y));
               const V3d wanted =
                   V3d(now.reference.at(x, y)) - V3d(before.reference.at(x, y));
               const V3d error = drawn - wanted;
               return std::abs(error.x) + std::abs(error.y) + std::abs(error.z);
             }) /
         3;
}

double TemporalFlip(const Frame& now, const Frame& before, int threads) {
  const MetricInput drawn(before.drawn, now.drawn, threads);
  const MetricInput wanted(before.reference, now.reference, threads);
  const ChannelPlane& drawn_map = FlipMap(drawn, kFlipPpd);
  const ChannelPlane& wanted_map = FlipMap(wanted, kFlipPpd);
  return MeanOverPixels(
      drawn.width(), drawn.height(), threads, [&](int x, int y) {
        return std::abs(drawn_map.row(y)[x] - wanted_map.row(y)[x]);
      });
}

}  // namespace rtb
