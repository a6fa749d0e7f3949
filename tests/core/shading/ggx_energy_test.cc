#include "core/shading/ggx_energy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/core/shading/bsdf_cases.h"

namespace rtb {
namespace {

TEST(GgxLossTest, ClosedFormForAlphaOneAtNormalIncidence) {
  // With alpha = 1 the stretched lengths are 1 and D = 1 / pi. From above,
  // f cos = D / (2 (cos_i + 1)) * cos_i, and the integral over the
  // hemisphere is int z / (1 + z) dz = 1 - ln 2.
  EXPECT_NEAR(GgxLossByQuadrature(1, 1, 48), std::log(2.0), 1e-9);
}

TEST(GgxLossTest, NothingIsLostAtGrazingViews) {
  // All facets that are seen at cos = 0 mirror upwards, and are seen as well
  // from there: the loss goes to 0.
  EXPECT_NEAR(GgxLossByQuadrature(0, 0.5, 48), 0, 1e-9);
  EXPECT_LT(GgxLossByQuadrature(1e-5, 0.5, 48), 1e-4);
}

TEST(GgxLossTest, QuadratureAgreesWithTheEvaluatedLobe) {
  // The single-scattering lobe of a white metal, over another chart.
  for (const float roughness : {0.1f, 0.4f, 1.0f}) {
    const float alpha = roughness * roughness;
    const BsdfData metal = TestMetal(Rgb(1), roughness);
    for (const float cosine : {0.05f, 0.5f, 1.0f}) {
      const V3f wo = DirectionAt(cosine);
      const double albedo = HemisphereIntegral(metal, wo, [&](const V3f& wi) {
                              const V3f h = (wo + wi).normalized();
                              return V3f(GgxDistribution(h, alpha) *
                                         GgxVisibility(wo, wi, alpha) * wi.z);
                            }).x;
      EXPECT_NEAR(1 - albedo, GgxLossByQuadrature(cosine, alpha, 48), 2e-5);
    }
  }
}

/// The greatest error of the table at one roughness.
double WorstError(float roughness) {
  const float alpha = roughness * roughness;
  double worst = 0;
  for (int i = 0; i <= 80; ++i) {
    // Dense around cos = alpha, where the loss of narrow lobes peaks.
    const double y = i / 80.0;
    const double cosine = alpha * y * y / (1 + alpha - y * y);
    const double exact = GgxLossByQuadrature(std::min(1.0, cosine), alpha, 32);
    worst = std::max(
        worst,
        std::abs(GgxLoss(TestEnergy(), static_cast<float>(cosine), alpha) -
                 exact));
  }
  return worst;
}

TEST(GgxLossTest, TableIsGoodTo2e4) {
  for (const float roughness : {0.01f, 0.02f, 0.05f, 0.11f, 0.24f, 0.39f, 0.5f,
                                0.63f, 0.7f, 0.77f, 0.9f, 0.97f, 1.0f}) {
    EXPECT_LT(WorstError(roughness), 2e-4) << roughness;
  }
}

TEST(GgxLossTest, ContinuousAtGrazingViews) {
  // From cos 0 up to 0.01 the loss rises without a step.
  float previous = 0;
  for (int i = 0; i <= 1000; ++i) {
    const float loss =
        GgxLoss(TestEnergy(), 1e-5f * static_cast<float>(i), 0.25f);
    EXPECT_GE(loss, previous);
    EXPECT_LT(loss - previous, 1e-4f);
    previous = loss;
  }
}

TEST(GgxAverageLossTest, IsTheCosineWeightedMean) {
  // Of the exact loss, with cos = x^2 against the steep rise at 0.
  for (const float roughness : {0.2f, 0.5f, 0.8f, 1.0f}) {
    const float alpha = roughness * roughness;
    double sum = 0;
    for (const QuadraturePoint& q : GaussLegendre(48)) {
      sum += q.weight * 4 * std::pow(q.x, 3) *
             GgxLossByQuadrature(q.x * q.x, alpha, 32);
    }
    EXPECT_NEAR(GgxAverageLoss(TestEnergy(), alpha), sum, 2e-4) << roughness;
  }
}

TEST(GgxEnergyTest, SameNumbersEveryTime) {
  EXPECT_EQ(MakeGgxEnergy().root_loss, MakeGgxEnergy().root_loss);
}

}  // namespace
}  // namespace rtb
