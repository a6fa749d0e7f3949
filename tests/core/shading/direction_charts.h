/// @file
/// Charts: maps between directions and the unit square, over which densities
/// are counted and integrated.
#pragma once

#include <cmath>
#include <numbers>

#include "core/math/vec.h"

namespace rtb {

/// A direction and the solid angle per area of the chart there.
struct ChartPoint {
  V3f direction{0};
  double stretch = 0;
};

/// The azimuth of (x, y) as a fraction of a turn, 0..1.
inline double TurnOf(float x, float y) {
  const double turn = std::atan2(y, x) / (2 * std::numbers::pi);
  return turn < 0 ? turn + 1 : turn;
}

/// All directions, by equal area: (z + 1) / 2 and the azimuth.
class SphereChart {
 public:
  V2d Of(const V3f& w) const { return {(w.z + 1) / 2, TurnOf(w.x, w.y)}; }
  ChartPoint At(const V2d& p) const {
    const double z = 2 * p.x - 1;
    const double r = std::sqrt(1 - z * z);
    const double phi = 2 * std::numbers::pi * p.y;
    return {V3f(V3d(r * std::cos(phi), r * std::sin(phi), z)),
            4 * std::numbers::pi};
  }
};

/// The directions above the surface by the half vector h with a given view:
/// p.y is its azimuth, and p.x the logarithm of 1 + slope / alpha as a share
/// of its limit, where h mirrors the view to the horizon. That resolves lobes
/// of any width and all that is around them.
class HalfVectorChart {
 public:
  HalfVectorChart(const V3f& wo, float alpha) : wo_(wo), alpha_(alpha) {}

  V2d Of(const V3f& wi) const {
    const V3d h = wo_ + V3d(wi);
    const double slope = std::hypot(h.x, h.y);
    const double turn =
        TurnOf(static_cast<float>(h.x), static_cast<float>(h.y));
    return {std::log1p(slope / h.z / alpha_) / Range(turn), turn};
  }
  ChartPoint At(const V2d& p) const {
    const double range = Range(p.y);
    const double shifted = alpha_ * std::exp(p.x * range);
    const double slope = shifted - alpha_;
    const double phi = 2 * std::numbers::pi * p.y;
    const double hz = 1 / std::sqrt(1 + slope * slope);
    const V3d h(slope * hz * std::cos(phi), slope * hz * std::sin(phi), hz);
    const double facing = wo_.dot(h);
    // d(wi) = 4 (o.h) d(h), d(h) = hz^3 slope d(slope) d(phi).
    return {V3f(h * (2 * facing) - wo_), 4 * facing * hz * hz * hz * slope *
                                             shifted * range * 2 *
                                             std::numbers::pi};
  }

 private:
  /// log(1 + m / alpha) at the greatest slope m of that azimuth: with k =
  /// tan(theta_o) cos(phi - phi_o), wi.z = 0 at m^2 - 2 m k - 1 = 0.
  double Range(double turn) const {
    const double phi = 2 * std::numbers::pi * turn;
    const double k = (wo_.x * std::cos(phi) + wo_.y * std::sin(phi)) / wo_.z;
    const double root = std::sqrt(k * k + 1);
    return std::log1p((k > 0 ? k + root : 1 / (root - k)) / alpha_);
  }

  V3d wo_;
  double alpha_;
};

}  // namespace rtb
