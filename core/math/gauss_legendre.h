/// @file
/// Gauss-Legendre quadrature for the host's precomputations and for tests.
#pragma once

#include <vector>

namespace rtb {

/// One abscissa of a quadrature rule over [0, 1] with its weight.
struct QuadraturePoint {
  double x = 0;
  double weight = 0;
};

/// The rule of `count` points over [0, 1], exact for polynomials up to degree
/// 2 count - 1, in ascending order; the weights add up to 1.
/// @param count at least 1.
std::vector<QuadraturePoint> GaussLegendre(int count);

}  // namespace rtb
