#include "core/math/gauss_legendre.h"

#include <cmath>
#include <numbers>

#include "core/base/check.h"

namespace rtb {
namespace {

/// A Legendre polynomial's value and derivative.
struct Legendre {
  double value = 0;
  double derivative = 0;
};

/// P_n at x by Bonnet's recurrence (DLMF 18.9.1), P_n' by DLMF 18.9.17.
Legendre LegendreAt(int n, double x) {
  double previous = 1;
  double current = x;
  for (int k = 2; k <= n; ++k) {
    const double next = ((2 * k - 1) * x * current - (k - 1) * previous) / k;
    previous = current;
    current = next;
  }
  return {current, n * (x * current - previous) / (x * x - 1)};
}

}  // namespace

std::vector<QuadraturePoint> GaussLegendre(int count) {
  RTB_CHECK_GE(count, 1);
  std::vector<QuadraturePoint> rule;
  for (int i = count; i >= 1; --i) {
    // The zeros of P_n, from Tricomi's leading term (DLMF 18.16.(ii)) by
    // Newton's method; it converges within 4 steps for any n.
    double x = std::cos(std::numbers::pi * (i - 0.25) / (count + 0.5));
    for (int step = 0; step < 8; ++step) {
      const Legendre p = LegendreAt(count, x);
      x -= p.value / p.derivative;
    }
    const double d = LegendreAt(count, x).derivative;
    // DLMF 3.5.22 for [-1, 1], halved for [0, 1].
    rule.push_back({(1 + x) / 2, 1 / ((1 - x * x) * d * d)});
  }
  return rule;
}

}  // namespace rtb
