#include "harness/metrics/flip_kernels.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace rtb {
namespace {

/// a sqrt(pi / b) exp(-pi^2 x^2 / b), x in degrees: the constants of the paper,
/// after Fourier transform.
struct Sensitivity {
  double a, b;

  /// Standard deviation in degrees.
  double Sigma() const { return std::sqrt(b / 2) / std::numbers::pi; }
  double Peak() const { return a * std::sqrt(std::numbers::pi / b); }
};

constexpr Sensitivity kAchromatic = {1, 0.0047};
constexpr Sensitivity kRedGreen = {1, 0.0053};
constexpr Sensitivity kBlueYellow[2] = {{34.1, 0.04}, {13.5, 0.025}};

/// w of section 4.2: the width of a feature, in degrees.
constexpr double kFeatureWidth = 0.082;

/// The discrete sum of exp(-x^2 / (2 sigma^2)).
double GaussianSum(double sigma, int radius) {
  double sum = 0;
  for (int x = -radius; x <= radius; ++x) {
    sum += std::exp(-x * x / (2 * sigma * sigma));
  }
  return sum;
}

/// Scales positive weights to add up to 1 and negative ones to -1.
void BalanceSigns(Kernel& kernel) {
  double positive = 0;
  double negative = 0;
  for (const double weight : kernel) {
    (weight > 0 ? positive : negative) += std::abs(weight);
  }
  for (double& weight : kernel) weight /= weight > 0 ? positive : negative;
}

}  // namespace

FlipSensitivity MakeFlipSensitivity(double ppd) {
  // All filters reach three standard deviations of the widest.
  const int radius =
      static_cast<int>(std::ceil(3 * kBlueYellow[0].Sigma() * ppd));
  const auto kernel = [&](const Sensitivity& s) {
    return GaussianKernel(s.Sigma() * ppd, radius);
  };
  FlipSensitivity filters = {kernel(kAchromatic),
                             kernel(kRedGreen),
                             {kernel(kBlueYellow[0]), kernel(kBlueYellow[1])},
                             {0, 0}};
  // Each kernel above sums to 1; its Gaussian's weight in the mixture is its
  // sum over the two-dimensional grid.
  for (int i = 0; i < 2; ++i) {
    const double sum = GaussianSum(kBlueYellow[i].Sigma() * ppd, radius);
    filters.share[i] = kBlueYellow[i].Peak() * sum * sum;
  }
  const double total = filters.share[0] + filters.share[1];
  for (double& share : filters.share) share /= total;
  return filters;
}

FlipFeatures MakeFlipFeatures(double ppd) {
  const double sigma = 0.5 * kFeatureWidth * ppd;
  const int radius = static_cast<int>(std::ceil(3 * sigma));
  FlipFeatures filters = {GaussianKernel(sigma, radius), {}, {}};
  for (int x = -radius; x <= radius; ++x) {
    const double weight =
        filters.gaussian[static_cast<std::size_t>(x + radius)];
    filters.edge.push_back(-x * weight);
    filters.point.push_back((x * x / (sigma * sigma) - 1) * weight);
  }
  BalanceSigns(filters.edge);
  BalanceSigns(filters.point);
  return filters;
}

}  // namespace rtb
