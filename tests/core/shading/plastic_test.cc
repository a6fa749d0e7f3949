#include "core/shading/plastic.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/shading/bsdf_cases.h"

namespace rtb {
namespace {

/// The closed form of the average over the outside (Walsh 1926; Judd,
/// "Fresnel Reflection of Diffusely Incident Light", J. Res. NBS 29, 1942,
/// equation 1).
double WalshAverage(double n) {
  const double n2 = n * n;
  const double n4 = n2 * n2;
  return 0.5 + (n - 1) * (3 * n + 1) / (6 * (n + 1) * (n + 1)) +
         n2 * (n2 - 1) * (n2 - 1) / std::pow(n2 + 1, 3) *
             std::log((n - 1) / (n + 1)) -
         2 * n * n2 * (n2 + 2 * n - 1) / ((n2 + 1) * (n4 - 1)) +
         8 * n4 * (n4 + 1) / ((n2 + 1) * (n4 - 1) * (n4 - 1)) * std::log(n);
}

TEST(AverageFresnelTest, IsWalshsClosedForm) {
  for (const double ior : {1.001, 1.05, 1.33, 1.5, 2.0, 4.0}) {
    EXPECT_NEAR(AverageFresnel(ior), WalshAverage(ior), 1e-8) << ior;
  }
  // The value that tables of diffuse reflectance have for glass.
  EXPECT_NEAR(AverageFresnel(1.5), 0.0918, 5e-5);
}

TEST(AverageFresnelTest, NothingWithoutAnInterface) {
  EXPECT_NEAR(AverageFresnel(1), 0, 1e-12);
}

TEST(AverageFresnelTest, InsideFollowsFromOutside) {
  // 2 int F cos d(cos) from inside, where all beyond the critical angle is
  // reflected: 1 / ior^2 of the cosine-weighted directions lie within it,
  // and with cos^2 = 1 - s / ior^2 they are uniform in s.
  const double n = 1.5;
  double sum = 1 - 1 / (n * n);
  for (const QuadraturePoint& q : GaussLegendre(200)) {
    sum += q.weight / (n * n) *
           DielectricReflectance(std::sqrt(1 - q.x / (n * n)), n);
  }
  EXPECT_NEAR(sum, 1 - (1 - AverageFresnel(n)) / (n * n), 1e-5);
}

TEST(PlasticTest, BaseAtNormalIncidence) {
  // T(i) T(o) albedo / (pi ior^2 (1 - R albedo)) with T = 0.96 and
  // R = 1 - (1 - average) / 2.25.
  const BsdfData plastic = TestPlastic(Rgb(0.5f), 1.5f, 0);
  const double r = 1 - (1 - WalshAverage(1.5)) / 2.25;
  const double expected =
      0.96 * 0.96 * 0.5 / (3.14159265 * 2.25 * (1 - r * 0.5));
  const V3f up(0, 0, 1);
  EXPECT_NEAR(EvalDiffuse(plastic, up, up).x, expected, 1e-6);
}

TEST(PlasticTest, IndexOneIsLambertian) {
  const BsdfData plastic = TestPlastic(Rgb(0.7f), 1, 0);
  EXPECT_NEAR(EvalBsdf(plastic, {}, DirectionAt(0.3f), DirectionAt(0.9f)).x,
              0.7 / 3.14159265, 1e-6);
}

}  // namespace
}  // namespace rtb
