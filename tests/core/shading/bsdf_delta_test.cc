#include <gtest/gtest.h>

#include "tests/core/shading/bsdf_cases.h"

namespace rtb {
namespace {

BsdfData Make(SurfaceModel model, const Rgb& color, float ior = 1.5f) {
  return MakeBsdf(model, color, ior, 0, {});
}

TEST(BsdfDeltaTest, MirrorReflectsTheSameAtEveryAngle) {
  const BsdfData mirror = Make(SurfaceModel::kMirror, Rgb(0.9f, 0.8f, 0.7f));
  for (const float cosine : {0.01f, 0.5f, 1.0f}) {
    const V3f wo = DirectionAt(cosine);
    const BsdfSample s = SampleBsdf(mirror, {}, wo, V3f(0.5f));
    EXPECT_EQ(s.wi, V3f(-wo.x, -wo.y, wo.z));
    EXPECT_EQ(s.weight, Rgb(0.9f, 0.8f, 0.7f));
    EXPECT_TRUE(s.delta);
    EXPECT_FALSE(s.transmitted);
    EXPECT_EQ(s.pdf, 0);
  }
}

TEST(BsdfDeltaTest, SmoothMetalHasSchlicksFresnel) {
  // At 60 degrees (1 - cos)^5 = 1/32: 0.2 + 0.8 / 32 = 0.225.
  const BsdfData metal = Make(SurfaceModel::kMetal, Rgb(0.2f, 0.5f, 1));
  const BsdfSample s = SampleBsdf(metal, {}, DirectionAt(0.5f), V3f(0.5f));
  EXPECT_NEAR(s.weight.x, 0.225, 1e-6);
  EXPECT_NEAR(s.weight.y, 0.5 + 0.5 / 32, 1e-6);
  EXPECT_EQ(s.weight.z, 1);
  EXPECT_TRUE(s.delta);
}

TEST(BsdfDeltaTest, GlassReflectsAndTransmitsAllOfIt) {
  // Whatever u chooses the weight is 1, so that R + T = 1; and it reflects
  // with the chance of the reflectance, from both sides.
  const BsdfData glass = Make(SurfaceModel::kDielectric, Rgb(1));
  for (const float cosine : {-1.0f, -0.9f, -0.76f, 0.05f, 0.3f, 1.0f}) {
    const V3f wo = DirectionAt(cosine);
    const float f =
        FresnelDielectric(std::abs(wo.z), cosine > 0 ? 1 / 1.5f : 1.5f);
    const BsdfSample reflected =
        SampleBsdf(glass, {}, wo, V3f(0.5f, 0.5f, f - 1e-4f));
    const BsdfSample refracted =
        SampleBsdf(glass, {}, wo, V3f(0.5f, 0.5f, f + 1e-4f));
    EXPECT_FALSE(reflected.transmitted);
    EXPECT_TRUE(refracted.transmitted);
    EXPECT_EQ(reflected.weight, Rgb(1));
    EXPECT_EQ(refracted.weight, Rgb(1));
    EXPECT_EQ(reflected.wi, V3f(-wo.x, -wo.y, wo.z));
    EXPECT_LT(refracted.wi.z * wo.z, 0);
  }
}

TEST(BsdfDeltaTest, GlassRefractsAfterSnellAndBack) {
  const BsdfData glass = Make(SurfaceModel::kDielectric, Rgb(1));
  const V3f wo = DirectionAt(0.6f);
  const BsdfSample in = SampleBsdf(glass, {}, wo, V3f(0.5f, 0.5f, 0.99f));
  // sin(o) = 0.8: the tangential part shrinks by 1.5 and turns about.
  EXPECT_NEAR(in.wi.x, -wo.x / 1.5f, 1e-6);
  EXPECT_NEAR(in.wi.y, -wo.y / 1.5f, 1e-6);
  EXPECT_NEAR(in.wi.z, -std::sqrt(1 - 0.64f / 2.25f), 1e-6);
  // Seen from inside along the refracted ray, light comes from wo.
  const BsdfSample out = SampleBsdf(glass, {}, in.wi, V3f(0.5f, 0.5f, 0.99f));
  EXPECT_LT((out.wi - wo).length(), 1e-6f);
}

TEST(BsdfDeltaTest, TotalInternalReflection) {
  // Inside, beyond sin = 1 / 1.5: nothing passes for any u.
  const BsdfData glass = Make(SurfaceModel::kDielectric, Rgb(0.5f));
  const V3f wo = DirectionAt(-0.7f);
  const BsdfSample s =
      SampleBsdf(glass, {}, wo, V3f(0.5f, 0.5f, 0x1.fffffep-1f));
  EXPECT_FALSE(s.transmitted);
  EXPECT_EQ(s.weight, Rgb(1));
  EXPECT_EQ(s.wi, V3f(-wo.x, -wo.y, wo.z));
}

TEST(BsdfDeltaTest, TintColorsWhatIsTransmittedAlone) {
  const Rgb tint(0.1f, 0.5f, 0.9f);
  const BsdfData glass = Make(SurfaceModel::kDielectric, tint);
  const V3f up(0, 0, 1);
  EXPECT_EQ(SampleBsdf(glass, {}, up, V3f(0, 0, 0.03f)).weight, Rgb(1));
  EXPECT_EQ(SampleBsdf(glass, {}, up, V3f(0, 0, 0.05f)).weight, tint);
}

TEST(BsdfDeltaTest, EmittersAndPhongAnswerBlack) {
  const V3f up(0, 0, 1);
  for (const SurfaceModel model :
       {SurfaceModel::kEmissive, SurfaceModel::kPhong}) {
    const BsdfData bsdf = Make(model, Rgb(5));
    const BsdfSample s = SampleBsdf(bsdf, {}, up, V3f(0.5f));
    EXPECT_EQ(s.weight, Rgb(0));
    EXPECT_FALSE(s.delta);
    EXPECT_EQ(EvalBsdf(bsdf, {}, up, up), Rgb(0));
    EXPECT_EQ(PdfBsdf(bsdf, {}, up, up), 0);
  }
}

/// What the predicates say of a model at a roughness.
struct Predicates {
  bool has_delta, has_spread;
};

Predicates Ask(SurfaceModel model, float roughness) {
  const BsdfData b = MakeBsdf(model, Rgb(1), 1.5f, roughness, TestEnergy());
  return {HasDelta(b), HasNonDelta(b)};
}

void ExpectPredicates(const Predicates& p, bool delta, bool spread) {
  EXPECT_EQ(p.has_delta, delta);
  EXPECT_EQ(p.has_spread, spread);
}

TEST(BsdfDeltaTest, Predicates) {
  ExpectPredicates(Ask(SurfaceModel::kLambertian, 0), false, true);
  ExpectPredicates(Ask(SurfaceModel::kMirror, 0), true, false);
  ExpectPredicates(Ask(SurfaceModel::kDielectric, 0), true, false);
  ExpectPredicates(Ask(SurfaceModel::kMetal, 0), true, false);
  ExpectPredicates(Ask(SurfaceModel::kMetal, 0.1f), false, true);
  ExpectPredicates(Ask(SurfaceModel::kPlastic, 0), true, true);
  ExpectPredicates(Ask(SurfaceModel::kPlastic, 0.1f), false, true);
  ExpectPredicates(Ask(SurfaceModel::kEmissive, 0), false, false);
  // Below kSmoothestAlpha: 0.003^2 = 9e-6.
  ExpectPredicates(Ask(SurfaceModel::kMetal, 0.003f), true, false);
}

}  // namespace
}  // namespace rtb
