#include "harness/metrics/hdr_flip.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/color/luminance.h"
#include "harness/metrics/metric.h"
#include "harness/metrics/rows.h"
#include "harness/results/statistics.h"

namespace rtb {
namespace {

/// (a x^2 + b x) / (c x^2 + d x + e). The fit maps 0.6 x; that factor is in the
/// coefficients, so that 1 stays the exposure at which a scene is displayed.
constexpr double kPreExposure = 0.6;
constexpr double kA = kPreExposure * kPreExposure * 2.51;
constexpr double kB = kPreExposure * 0.03;
constexpr double kC = kPreExposure * kPreExposure * 2.43;
constexpr double kD = kPreExposure * 0.59;
constexpr double kE = 0.14;

/// What the largest luminance, and later the median, is to be toned to.
constexpr double kTarget = 0.85;

/// The x that ACES tones to kTarget: the positive root of
/// (a - t c) x^2 + (b - t d) x - t e.
double SolveTarget() {
  const double a = kA - kTarget * kC;
  const double b = kB - kTarget * kD;
  const double c = -kTarget * kE;
  return (-b + std::sqrt(b * b - 4 * a * c)) / (2 * a);
}

double Positive(float value) { return std::max(0.0, double{value}); }

std::vector<double> Luminances(const Image& linear) {
  std::vector<double> luminances;
  luminances.reserve(linear.pixels().size());
  for (const Rgb& p : linear.pixels()) {
    luminances.push_back(
        Luminance(V3d(Positive(p.x), Positive(p.y), Positive(p.z))));
  }
  return luminances;
}

ColorPlanes Toned(const Image& linear, double stops, int threads) {
  const double gain = std::exp2(stops);
  const auto tone = [gain](float value) {
    return std::clamp(AcesTone(gain * Positive(value)), 0.0, 1.0);
  };
  const ChannelPlane empty(linear.width(), linear.height());
  ColorPlanes planes = {empty, empty, empty};
  ForRows(linear.height(), threads, [&](int y) {
    for (int x = 0; x < linear.width(); ++x) {
      const Rgb& pixel = linear.at(x, y);
      planes[0].row(y)[x] = tone(pixel.x);
      planes[1].row(y)[x] = tone(pixel.y);
      planes[2].row(y)[x] = tone(pixel.z);
    }
  });
  return planes;
}

/// Images that a display would be given have no more exposures to look at.
std::optional<double> Undefined(const MetricInput&) { return std::nullopt; }

}  // namespace

double AcesTone(double x) {
  return (kA * x * x + kB * x) / (kC * x * x + kD * x + kE);
}

Result<ExposureRange> FlipExposures(const Image& reference) {
  const std::vector<double> luminances = Luminances(reference);
  const double largest = *std::ranges::max_element(luminances);
  const double median = Median(luminances);
  if (!std::isfinite(largest)) {
    return Fail(BadInput("hdr_flip", "the reference is not finite"));
  }
  if (!(median > 0)) {
    return Fail(
        BadInput("hdr_flip",
                 "more than half of the reference is black: no exposure shows "
                 "its median luminance"));
  }
  const double target = SolveTarget();
  ExposureRange range{std::log2(target / largest), std::log2(target / median),
                      2};
  range.count =
      std::max(2, static_cast<int>(std::ceil(range.stop - range.start)));
  return range;
}

Result<double> HdrFlip(const Image& reference, const Image& test, int threads,
                       double ppd) {
  if (reference.width() != test.width() ||
      reference.height() != test.height() || reference.empty()) {
    return Fail(BadInput("hdr_flip", "compares linear images of one size"));
  }
  RTB_ASSIGN_OR_RETURN(const ExposureRange range, FlipExposures(reference));
  ChannelPlane worst(reference.width(), reference.height());
  for (int i = 0; i < range.count; ++i) {
    const double stops = range.At(i);
    const ChannelPlane map =
        FlipMapOfLinear(Toned(reference, stops, threads),
                        Toned(test, stops, threads), ppd, threads);
    worst = CombinePlanes(worst, map, threads,
                          [](double a, double b) { return std::max(a, b); });
  }
  return Mean(worst.values());
}

Metric HdrFlipMetric() {
  return {
      "hdr_flip",
      "mean HDR-FLIP (Andersson et al. 2021, ACES) at 40 pixels per degree, 0 "
      "to 1; of two linear renders that `score` reads, else undefined",
      true, Undefined};
}

}  // namespace rtb
