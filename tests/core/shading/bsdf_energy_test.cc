// White furnaces: what a surface reflects of uniform radiance 1.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <initializer_list>

#include "core/math/sampling.h"
#include "tests/core/shading/bsdf_cases.h"

namespace rtb {
namespace {

constexpr std::initializer_list<float> kCosines = {0.02f, 0.05f, 0.1f, 0.2f,
                                                   0.4f,  0.7f,  1.0f};

/// What a smooth surface mirrors, by the samples' weight times their chance.
float DeltaAlbedo(const BsdfData& bsdf, const V3f& wo) {
  const BsdfSample s = SampleBsdf(bsdf, TestEnergy(), wo, V3f(0));
  return s.delta ? s.weight.x * SpecularChance(bsdf, wo) : 0;
}

/// The cosine-weighted mean over the views of the whole albedo.
double MeanAlbedo(const BsdfData& bsdf) {
  double sum = 0;
  for (const QuadraturePoint& q : GaussLegendre(16)) {
    const V3f wo = DirectionAt(static_cast<float>(q.x));
    sum +=
        q.weight * 2 * q.x * (SpreadAlbedo(bsdf, wo).x + DeltaAlbedo(bsdf, wo));
  }
  return sum;
}

TEST(BsdfEnergyTest, WhiteRoughMetalReflectsAll) {
  for (const float roughness :
       {0.05f, 0.1f, 0.2f, 0.3f, 0.45f, 0.6f, 0.75f, 0.9f, 1.0f}) {
    for (const float cosine : kCosines) {
      EXPECT_NEAR(
          SpreadAlbedo(TestMetal(Rgb(1), roughness), DirectionAt(cosine)).x, 1,
          1e-3)
          << roughness << " " << cosine;
    }
  }
}

TEST(BsdfEnergyTest, NarrowLobesKeepTheirEnergy) {
  // In float: the half vectors of a lobe of alpha 1e-4 or 9e-4.
  for (const float roughness : {0.01f, 0.03f}) {
    for (const float cosine : kCosines) {
      EXPECT_NEAR(
          SpreadAlbedo(TestMetal(Rgb(1), roughness), DirectionAt(cosine)).x, 1,
          1e-2)
          << roughness << " " << cosine;
    }
  }
}

TEST(BsdfEnergyTest, SamplesOfGrazingViewsKeepItToo) {
  // Where the chart's quadrature ends: weights, which the density cancels in.
  for (const float roughness : {0.01f, 0.1f, 0.5f, 1.0f}) {
    const BsdfData metal = TestMetal(Rgb(1), roughness);
    for (const float cosine : {1e-4f, 1e-3f, 1e-2f}) {
      double sum = 0;
      constexpr std::uint32_t kCount = 40000;
      for (std::uint32_t i = 0; i < kCount; ++i) {
        sum += SampleBsdf(metal, TestEnergy(), DirectionAt(cosine),
                          RandomUniforms(i, 3))
                   .weight.x;
      }
      EXPECT_NEAR(sum / kCount, 1, 1e-2) << roughness << " " << cosine;
    }
  }
}

TEST(BsdfEnergyTest, StratifiedGlossyRaysEstimateTheLobeAlone) {
  // Plastic's lobe without its base: 8 rays at a time, as Whitted's
  // integrator takes them, averaged over many patterns.
  const BsdfData plastic = TestPlastic(Rgb(1), 1.5f, 0.4f);
  for (const float cosine : {0.2f, 0.9f}) {
    const V3f wo = DirectionAt(cosine);
    double sum = 0;
    double squares = 0;
    constexpr std::uint32_t kPatterns = 4000;
    for (std::uint32_t pattern = 0; pattern < kPatterns; ++pattern) {
      double of_8 = 0;
      for (std::uint32_t i = 0; i < 8; ++i) {
        const V2f u = MultiJittered(i, 8, pattern);
        of_8 += SampleGlossy(plastic, TestEnergy(), wo, u).weight.x / 8;
      }
      sum += of_8 / kPatterns;
      squares += of_8 * of_8 / kPatterns;
    }
    const double exact =
        HemisphereIntegral(plastic, wo, [&](const V3f& wi) {
          return EvalGlossy(plastic, TestEnergy(), wo, wi) * wi.z;
        }).x;
    const double deviation = std::sqrt((squares - sum * sum) / kPatterns);
    EXPECT_NEAR(sum, exact, 4 * deviation + 1e-5);
  }
}

TEST(BsdfEnergyTest, ColoredMetalLosesWithEachBounce) {
  // Facets that reflect 0.8 at any bounce, a white metal's 1: between them.
  // With Schlick's mean F = (20 * 0.8 + 1) / 21 = 0.8095 and E the mean
  // albedo, the mean is near F E / (1 - F (1 - E)), the whole series.
  const BsdfData metal = TestMetal(Rgb(0.8f), 1);
  const double e = 1 - metal.average_loss;
  const double f = 17.0 / 21;
  EXPECT_NEAR(MeanAlbedo(metal), f * e / (1 - f * (1 - e)), 0.02);
}

TEST(BsdfEnergyTest, LambertianReflectsItsAlbedo) {
  const BsdfData paper =
      MakeBsdf(SurfaceModel::kLambertian, Rgb(1, 0.5f, 0), 1, 0, {});
  const V3d albedo = SpreadAlbedo(paper, DirectionAt(0.3f));
  EXPECT_NEAR(albedo.x, 1, 1e-5);
  EXPECT_NEAR(albedo.y, 0.5, 1e-5);
  EXPECT_EQ(albedo.z, 0);
}

TEST(BsdfEnergyTest, SmoothWhitePlasticReflectsAll) {
  for (const float ior : {1.0f, 1.1f, 1.5f, 2.4f, 4.0f}) {
    const BsdfData plastic = TestPlastic(Rgb(1), ior, 0);
    for (const float cosine : kCosines) {
      const V3f wo = DirectionAt(cosine);
      EXPECT_NEAR(SpreadAlbedo(plastic, wo).x + DeltaAlbedo(plastic, wo), 1,
                  1e-4)
          << ior << " " << cosine;
    }
  }
}

/// The energy that rough white plastic may lose, by roughness.
struct PlasticLoss {
  float roughness;
  double most;
};

TEST(BsdfEnergyTest, RoughWhitePlasticGainsNothingOnTheWhole) {
  // The base is lit as through a smooth coat while the lobe has the Fresnel
  // term of its facets, so that the two do not add up to just 1. Over all
  // views that loses, the more the rougher and denser the coat: at index 1.5
  // 0.1 % at roughness 0.1, 0.4 % at 0.2, 2 % at 0.4 and 7 % at 1; at 2.4
  // 12.5 % at roughness 1.
  for (const PlasticLoss& loss : {PlasticLoss{0.05f, 1e-3},
                                  {0.1f, 1e-3},
                                  {0.2f, 6e-3},
                                  {0.4f, 0.03},
                                  {1.0f, 0.13}}) {
    for (const float ior : {1.1f, 1.5f, 2.4f}) {
      const double mean = MeanAlbedo(TestPlastic(Rgb(1), ior, loss.roughness));
      EXPECT_LT(mean, 1.0005) << ior << " " << loss.roughness;
      EXPECT_GT(mean, 1 - loss.most) << ior << " " << loss.roughness;
    }
  }
}

TEST(BsdfEnergyTest, PlasticOfBlackBaseIsItsCoat) {
  // The coat of index 1.5 mirrors 0.04 at normal incidence; the black base
  // adds nothing.
  const BsdfData plastic = TestPlastic(Rgb(0), 1.5f, 0);
  EXPECT_NEAR(DeltaAlbedo(plastic, V3f(0, 0, 1)), 0.04, 1e-6);
  EXPECT_EQ(SpreadAlbedo(plastic, V3f(0, 0, 1)), V3d(0));
}

}  // namespace
}  // namespace rtb
