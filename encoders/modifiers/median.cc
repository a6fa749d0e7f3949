#include "encoders/modifiers/median.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/check.h"

namespace rtb {
namespace {

constexpr int kIterations = 100;
/// Steps shorter than this, in the blend space, decide no 8-bit code.
constexpr double kConverged = kNoise / 10;

V3d WeightedMean(std::span<const V3d> samples,
                 std::span<const double> weights) {
  V3d sum(0);
  double total = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    sum += weights[i] * samples[i];
    total += weights[i];
  }
  RTB_CHECK(total > 0);
  return sum / total;
}

/// One step from `at`.
V3d Step(std::span<const V3d> samples, std::span<const double> weights,
         const V3d& at) {
  V3d pull(0);         // sum of w (s - at) / |s - at|
  double inverse = 0;  // sum of w / |s - at|
  double here = 0;     // weight of the samples at `at`
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const V3d way = samples[i] - at;
    const double distance = way.length();
    if (distance < kConverged) {
      here += weights[i];
      continue;
    }
    pull += weights[i] / distance * way;
    inverse += weights[i] / distance;
  }
  const double strength = pull.length();
  if (inverse == 0 || strength <= here) return at;
  return at + (1 - here / strength) / inverse * pull;
}

}  // namespace

V3d GeometricMedian(std::span<const V3d> samples,
                    std::span<const double> weights) {
  RTB_CHECK_EQ(samples.size(), weights.size());
  V3d median = WeightedMean(samples, weights);
  for (int i = 0; i < kIterations; ++i) {
    const V3d next = Step(samples, weights, median);
    const double step = (next - median).length();
    median = next;
    if (step < kConverged) break;
  }
  return median;
}

Cell WithMedianColors(Cell cell, const FitMask& mask, Blend blend,
                      std::span<const V3d> samples) {
  std::vector<double> weights(samples.size());
  for (const bool foreground : {true, false}) {
    std::ranges::transform(mask.coverage, weights.begin(), [&](double m) {
      return std::max(0.0, foreground ? 2 * m - 1 : 1 - 2 * m);
    });
    if (std::ranges::all_of(weights, [](double w) { return w == 0; })) continue;
    (foreground ? cell.fg : cell.bg) =
        ToRgb8(blend, GeometricMedian(samples, weights));
  }
  return cell;
}

}  // namespace rtb
