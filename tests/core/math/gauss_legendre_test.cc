#include "core/math/gauss_legendre.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rtb {
namespace {

TEST(GaussLegendreTest, TwoPointsInClosedForm) {
  // 1/2 -+ 1 / (2 sqrt 3), weights 1/2.
  const std::vector<QuadraturePoint> rule = GaussLegendre(2);
  EXPECT_NEAR(rule[0].x, 0.5 - 0.5 / std::sqrt(3.0), 1e-15);
  EXPECT_NEAR(rule[1].x, 0.5 + 0.5 / std::sqrt(3.0), 1e-15);
  EXPECT_NEAR(rule[0].weight, 0.5, 1e-15);
}

TEST(GaussLegendreTest, ExactUpToTheDegreeAndNotBeyond) {
  for (const int count : {1, 2, 5, 12, 48, 200}) {
    const std::vector<QuadraturePoint> rule = GaussLegendre(count);
    // int x^d = 1 / (d + 1)
    for (const int degree : {0, count, 2 * count - 1}) {
      double sum = 0;
      for (const auto& q : rule) sum += q.weight * std::pow(q.x, degree);
      EXPECT_NEAR(sum, 1.0 / (degree + 1), 1e-13) << count << " " << degree;
    }
  }
  double sum = 0;
  for (const auto& q : GaussLegendre(2)) sum += q.weight * std::pow(q.x, 4);
  EXPECT_GT(std::abs(sum - 0.2), 1e-3);
}

}  // namespace
}  // namespace rtb
