#include "core/shading/microfacet.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/shading/bsdf_cases.h"

namespace rtb {
namespace {

constexpr double kPiD = 3.14159265358979324;

TEST(GgxDistributionTest, PeakAndHalfWidth) {
  // At the normal 1 / (pi alpha^2), however narrow; at tan = alpha,
  // cos^-4 / (pi alpha^2 2^2).
  for (const float alpha : {1e-5f, 1e-4f, 0.01f, 0.5f, 1.0f}) {
    const double peak = 1 / (kPiD * alpha * alpha);
    EXPECT_NEAR(GgxDistribution(V3f(0, 0, 1), alpha) / peak, 1, 1e-5);
    const double cos2 = 1 / (1.0 + alpha * alpha);
    const V3f h(static_cast<float>(alpha * std::sqrt(cos2)), 0,
                static_cast<float>(std::sqrt(cos2)));
    EXPECT_NEAR(GgxDistribution(h, alpha) / peak, 0.25 / (cos2 * cos2), 1e-5);
  }
}

TEST(GgxDistributionTest, AlphaOneIsUniformOverProjectedDirections) {
  EXPECT_NEAR(GgxDistribution(DirectionAt(0.3f), 1), 1 / kPiD, 1e-6);
}

TEST(GgxDistributionTest, ProjectedAreaIsOne) {
  // int D cos dw = 1; with tan = alpha tan(psi) over psi.
  for (const float alpha : {0.001f, 0.1f, 0.7f}) {
    double sum = 0;
    for (const QuadraturePoint& q : GaussLegendre(32)) {
      const double psi = q.x * kPiD / 2;
      const double tangent = alpha * std::tan(psi);
      const double cosine = 1 / std::sqrt(1 + tangent * tangent);
      const double stretch = alpha / (std::cos(psi) * std::cos(psi)) * kPiD / 2;
      const float x = static_cast<float>(tangent * cosine);
      sum += q.weight * 2 * kPiD * tangent * std::pow(cosine, 4) * stretch *
             GgxDistribution(V3f(x, 0, static_cast<float>(cosine)), alpha);
    }
    EXPECT_NEAR(sum, 1, 1e-5) << alpha;
  }
}

/// Smith's Lambda in float64 as Heitz 2014, equation 72, has it.
double Lambda(double cosine, double alpha) {
  const double tan2 = (1 - cosine * cosine) / (cosine * cosine);
  return (std::sqrt(1 + alpha * alpha * tan2) - 1) / 2;
}

TEST(GgxVisibilityTest, IsTheHeightCorrelatedSmithTerm) {
  for (const float alpha : {0.01f, 0.3f, 1.0f}) {
    for (const float o : {0.01f, 0.4f, 1.0f}) {
      for (const float i : {0.02f, 0.7f}) {
        const double g2 = 1 / (1 + Lambda(o, alpha) + Lambda(i, alpha));
        const double expected = g2 / (4.0 * o * i);
        const float found =
            GgxVisibility(DirectionAt(o), DirectionAt(i), alpha);
        EXPECT_NEAR(found / expected, 1, 1e-5);
      }
    }
  }
}

TEST(VisibleReflectionPdfTest, IsTheVisibleNormalsDensity) {
  // D(h) G1(o) (o.h) / cos_o, over 4 (o.h): Heitz 2018, equations 3 and 17.
  const V3f wo = DirectionAt(0.3f);
  const V3f h = DirectionAt(0.8f, 1.1f);
  const double expected =
      GgxDistribution(h, 0.4f) / (1 + Lambda(0.3, 0.4)) / (4 * 0.3);
  EXPECT_NEAR(VisibleReflectionPdf(wo, h, 0.4f) / expected, 1, 1e-5);
}

TEST(SampleVisibleNormalTest, UnitUpwardsAndTowardsTheViewer) {
  for (const float alpha : {1e-5f, 1e-3f, 0.2f, 1.0f}) {
    for (const float cosine : {1e-4f, 0.3f, 1.0f}) {
      const V3f wo = DirectionAt(cosine);
      for (std::uint32_t i = 0; i < 500; ++i) {
        const V3f u = RandomUniforms(i, 5);
        const V3f h = SampleVisibleNormal(wo, alpha, V2f(u.x, u.y));
        EXPECT_NEAR(h.length(), 1, 1e-6);
        EXPECT_GE(h.z, 0);
        EXPECT_GE(wo.dot(h), -1e-6f);
      }
    }
  }
}

TEST(SampleVisibleNormalTest, SlopesScaleWithAlpha) {
  // From straight above slopes / alpha follow one distribution: the same
  // uniforms give the same quotient.
  const V3f up(0, 0, 1);
  const V2f u(0.3f, 0.6f);
  const V3f wide = SampleVisibleNormal(up, 0.1f, u);
  const V3f narrow = SampleVisibleNormal(up, 1e-4f, u);
  EXPECT_NEAR(narrow.x / narrow.z * 1000 / (wide.x / wide.z), 1, 1e-5);
}

}  // namespace
}  // namespace rtb
