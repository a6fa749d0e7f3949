#include "core/shading/plastic.h"

#include <cmath>

#include "core/math/gauss_legendre.h"

namespace rtb {
namespace {

/// FresnelDielectric in float64, from outside; cos > 0.
double Fresnel(double cosine, double ior) {
  const double cos_t = std::sqrt(ior * ior - 1 + cosine * cosine) / ior;
  const double s = (cosine - ior * cos_t) / (cosine + ior * cos_t);
  const double p = (ior * cosine - cos_t) / (ior * cosine + cos_t);
  return (s * s + p * p) / 2;
}

}  // namespace

double AverageFresnel(double ior) {
  double sum = 0;
  // cos = x^3 gathers points at grazing angles, where F rises the more
  // suddenly the closer ior is to 1: 2 cos d(cos) = 6 x^5 dx.
  for (const QuadraturePoint& q : GaussLegendre(64)) {
    sum += q.weight * 6 * std::pow(q.x, 5) * Fresnel(std::pow(q.x, 3), ior);
  }
  return sum;
}

}  // namespace rtb
