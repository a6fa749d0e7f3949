#include "core/shading/plastic.h"

#include <cmath>

#include "core/math/gauss_legendre.h"

namespace rtb {

double AverageFresnel(double ior) {
  double sum = 0;
  // cos = x^3 gathers points at grazing angles, where F rises the more
  // suddenly the closer ior is to 1: 2 cos d(cos) = 6 x^5 dx.
  for (const QuadraturePoint& q : GaussLegendre(64)) {
    sum += q.weight * 6 * std::pow(q.x, 5) *
           DielectricReflectance(std::pow(q.x, 3), 1 / ior);
  }
  return sum;
}

}  // namespace rtb
