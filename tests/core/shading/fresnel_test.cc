#include "core/shading/fresnel.h"

#include <gtest/gtest.h>

namespace rtb {
namespace {

TEST(FresnelDielectricTest, NormalIncidence) {
  // ((n - 1) / (n + 1))^2 = 0.04 for n = 1.5, from either side.
  EXPECT_NEAR(FresnelDielectric(1, 1 / 1.5f), 0.04f, 1e-7f);
  EXPECT_NEAR(FresnelDielectric(1, 1.5f), 0.04f, 1e-7f);
}

TEST(FresnelDielectricTest, BrewsterHasHalfTheSReflectance) {
  // At tan(i) = n the p part vanishes and the s part is
  // ((1 - n^2) / (1 + n^2))^2; unpolarized light sees half of that.
  const double n = 1.5;
  const double cos_i = 1 / std::sqrt(1 + n * n);
  const double s = (1 - n * n) / (1 + n * n);
  EXPECT_NEAR(FresnelDielectric(static_cast<float>(cos_i), 1 / 1.5f), s * s / 2,
              1e-6);
}

TEST(FresnelDielectricTest, TotalInternalReflectionBeyondTheCriticalAngle) {
  // Inside glass the critical angle has sin = 1/1.5, cos = 0.745356.
  EXPECT_EQ(FresnelDielectric(0.7453f, 1.5f), 1);
  EXPECT_LT(FresnelDielectric(0.7460f, 1.5f), 1);
  EXPECT_EQ(FresnelDielectric(0.1f, 1.5f), 1);
}

TEST(FresnelDielectricTest, ReciprocalUnderSnell) {
  for (float cos_i = 0.05f; cos_i <= 1; cos_i += 0.05f) {
    const float sin_t = std::sqrt(1 - cos_i * cos_i) / 1.5f;
    const float cos_t = std::sqrt(1 - sin_t * sin_t);
    EXPECT_NEAR(FresnelDielectric(cos_i, 1 / 1.5f),
                FresnelDielectric(cos_t, 1.5f), 2e-6f);
  }
}

TEST(FresnelDielectricTest, GrazingReflectsAll) {
  EXPECT_NEAR(FresnelDielectric(0, 1 / 1.5f), 1, 1e-6f);
}

TEST(FresnelSchlickTest, EndsAndMiddle) {
  const Rgb f0(0.2f, 0.5f, 0.9f);
  EXPECT_EQ(FresnelSchlick(f0, 1), f0);
  EXPECT_EQ(FresnelSchlick(f0, 0), Rgb(1));
  EXPECT_NEAR(FresnelSchlick(f0, 0.5f).x, 0.2 + 0.8 / 32, 1e-7);
}

TEST(ReflectTest, MirrorsAboutTheNormal) {
  const V3f d = V3f(3, -4, 0) / 5;
  const V3f r = Reflect(d, V3f(0, 1, 0));
  EXPECT_LT((r - V3f(3, 4, 0) / 5).length(), 1e-6f);
}

TEST(RefractTest, ObeysSnell) {
  // 45 degrees into glass: sin(t) = sin(45) / 1.5.
  const V3f d = V3f(1, -1, 0).normalized();
  const V3f t = Refract(d, V3f(0, 1, 0), 1 / 1.5f);
  EXPECT_NEAR(t.x, std::sqrt(0.5f) / 1.5f, 1e-6f);
  EXPECT_LT(t.y, 0);
  EXPECT_NEAR(t.length(), 1, 1e-6f);
}

TEST(RefractTest, StraightOnAtNormalIncidenceAndForEqualIndices) {
  EXPECT_EQ(Refract(V3f(0, -1, 0), V3f(0, 1, 0), 1.7f), V3f(0, -1, 0));
  const V3f d = V3f(1, -2, 0.5f).normalized();
  EXPECT_LT((Refract(d, V3f(0, 1, 0), 1) - d).length(), 1e-6f);
}

TEST(RefractTest, SlabShiftsByTheClosedForm) {
  // A ray leaves a slab of thickness d in its old direction, shifted across
  // it by d sin(i) (1 - cos(i) / sqrt(n^2 - sin^2(i))).
  const V3f up(0, 1, 0);
  for (const float sine : {0.1f, 0.5f, 0.9f}) {
    const float cosine = std::sqrt(1 - sine * sine);
    const V3f d(sine, -cosine, 0);
    const V3f inside = Refract(d, up, 1 / 1.5f);
    EXPECT_LT((Refract(inside, up, 1.5f) - d).length(), 1e-6f);
    const V3f exit = inside / -inside.y;  // thickness 1
    const float shift = exit.cross(d).length();
    EXPECT_NEAR(shift, sine * (1 - cosine / std::sqrt(2.25f - sine * sine)),
                1e-6f);
  }
}

TEST(RefractTest, IntoTheThinnerSideBendsAway) {
  // 30 degrees inside glass: sin(t) = 0.75.
  const V3f d(0.5f, -std::sqrt(0.75f), 0);
  EXPECT_NEAR(Refract(d, V3f(0, 1, 0), 1.5f).x, 0.75f, 1e-6f);
}

TEST(FresnelDielectricTest, BrewsterInsideIsItsPartnerOutside) {
  // tan(i) = 1 / n from inside: the same half of the s reflectance.
  const double n = 1.5;
  const double cos_i = n / std::sqrt(1 + n * n);
  const double s = (1 - n * n) / (1 + n * n);
  EXPECT_NEAR(FresnelDielectric(static_cast<float>(cos_i), 1.5f), s * s / 2,
              1e-6);
}

}  // namespace
}  // namespace rtb
