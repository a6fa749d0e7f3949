#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/core/shading/light_tools.h"

namespace rtb {
namespace {

struct NamedLight {
  std::string name;
  LightData light;
};

/// All around (0, 2, 0), to be seen from the origin.
std::vector<NamedLight> LightsWithExtent() {
  return {
      {"rectangle",
       MakeQuad(V3d(-1, 2, -1), V3d(3, 0, 0), V3d(0, 0, 2), Rgb(1))},
      {"far rectangle", MakeQuad(V3d(-0.05, 2, -0.05), V3d(0.15, 0, 0),
                                 V3d(0, 0, 0.15), Rgb(1))},
      {"parallelogram",
       MakeQuad(V3d(-1, 2, -1), V3d(3, 0.5, 0), V3d(1, 0, 2), Rgb(1))},
      {"triangle",
       TriangleLight(V3f(-1, 2, -1), V3f(0, 3, 2), V3f(2, 2, 0), Rgb(1))},
      {"sphere", MakeSphere(V3d(0.3, 2, 0.2), 0.9, Rgb(1))},
  };
}

/// Distance to the light along a direction from the origin; negative where it
/// is missed.
float HitDistance(const LightData& light, const V3f& direction) {
  const V3f& p = light.position;
  if (light.model == LightModel::kSphere) {
    const float along = p.dot(direction);
    const float miss2 = (p - direction * along).length2();
    const float half2 = light.radius * light.radius - miss2;
    return half2 > 0 && along > 0 ? along - std::sqrt(half2) : -1;
  }
  const float t = p.dot(light.direction) / direction.dot(light.direction);
  // Coordinates along the edges by areas against the normal.
  const V3f at = direction * t - p;
  const V3f n = light.edge0.cross(light.edge1);
  const float a = at.cross(light.edge1).dot(n) / n.length2();
  const float b = light.edge0.cross(at).dot(n) / n.length2();
  const bool triangle = light.model == LightModel::kTriangle;
  const bool inside = a >= 0 && b >= 0 && (triangle ? a + b : a) <= 1 && b <= 1;
  return t > 0 && inside ? t : -1;
}

TEST(LightPdfTest, EqualsThatOfTheSample) {
  for (const auto& [name, light] : LightsWithExtent()) {
    MeanOverSquare(16, [&](const V2f& u) {
      const LightSample s = SampleLight(light, V3f(0), u);
      EXPECT_GT(s.pdf, 0) << name;
      EXPECT_FLOAT_EQ(LightPdf(light, V3f(0), s.direction, s.distance), s.pdf)
          << name;
      // And the irradiance is radiance / pdf.
      EXPECT_NEAR(s.irradiance.x * s.pdf, 1, 1e-5) << name;
      return 0;
    });
  }
}

TEST(LightPdfTest, SamplesHitTheLightAtTheirDistance) {
  for (const auto& [name, light] : LightsWithExtent()) {
    MeanOverSquare(16, [&](const V2f& u) {
      const LightSample s = SampleLight(light, V3f(0), u);
      EXPECT_NEAR(HitDistance(light, s.direction), s.distance, 1e-4) << name;
      return 0;
    });
  }
}

// Over all directions that hit the light. Only cells on its outline err: by
// some 1e-3 for 1.3 million cells, more for the small one.
TEST(LightPdfTest, IntegratesToOneOverDirections) {
  for (const auto& [name, light] : LightsWithExtent()) {
    const double integral = IntegralOverSphere(800, [&](const V3f& d) {
      const float distance = HitDistance(light, d);
      return distance > 0 ? LightPdf(light, V3f(0), d, distance) : 0.0f;
    });
    EXPECT_NEAR(integral, 1, name == "far rectangle" ? 0.03 : 3e-3) << name;
  }
}

// Half of the samples by direction in place of by light: the balance heuristic
// of the two, which LightPdf makes possible, gives the same irradiance.
TEST(LightPdfTest, BalanceHeuristicAgreesWithSamplingTheLight) {
  const V3f up(0, 1, 0);
  for (const auto& [name, light] : LightsWithExtent()) {
    const double expected = Irradiance(light, V3f(0), up, 256);
    constexpr float kUniform = 1 / (4 * std::numbers::pi_v<float>);
    const double by_light = MeanOverSquare(256, [&](const V2f& u) {
      const LightSample s = SampleLight(light, V3f(0), u);
      return CosineWeighted(s, up) * s.pdf / (s.pdf + kUniform);
    });
    const double by_direction = IntegralOverSphere(600, [&](const V3f& d) {
      const float distance = HitDistance(light, d);
      if (!(distance > 0) || d.y <= 0) return 0.0f;
      const float pdf = LightPdf(light, V3f(0), d, distance);
      return d.y * kUniform / (pdf + kUniform);
    });
    EXPECT_NEAR(by_light + by_direction, expected, 2e-3 * expected) << name;
  }
}

}  // namespace
}  // namespace rtb
