#include <gtest/gtest.h>

#include <array>

#include "tests/core/shading/light_tools.h"

namespace rtb {
namespace {

using Corners = std::array<V3d, 4>;

/// Counter-clockwise from the side of e0 x e1, where it shines.
Corners CornersOf(const V3d& corner, const V3d& e0, const V3d& e1) {
  return {corner, corner + e0, corner + e0 + e1, corner + e1};
}

double IrradianceByArea(const LightData& light, const V3f& position,
                        const V3f& normal, int n) {
  return MeanOverSquare(n, [&](const V2f& u) {
    return CosineWeighted(SampleLightByArea(light, position, u), normal);
  });
}

/// A panel at height 2 that shines down: e0 x e1 = -y.
const V3d kCorner(-1, 2, -1);
const V3d kAcross(3, 0, 0);
const V3d kAlong(0, 0, 2);
/// From below that is clockwise, whence the sign.
double PanelIrradiance(const V3d& e1, const V3d& position, const V3d& normal) {
  return -PolygonIrradiance(CornersOf(kCorner, kAcross, e1), position, normal);
}

TEST(QuadLightTest, IrradianceIsLamberts) {
  const LightData panel = MakeQuad(kCorner, kAcross, kAlong, Rgb(1));
  ASSERT_EQ(panel.direction, V3f(0, -1, 0));
  ASSERT_TRUE(panel.rectangle);
  const V3d up(0, 1, 0);
  const V3d slanted = V3d(0.2, 1, -0.3).normalized();
  for (const V3d& at : {V3d(0), V3d(1, 1, 0.5), V3d(-4, 0, 1)}) {
    for (const V3d& normal : {up, slanted}) {
      const double expected = PanelIrradiance(kAlong, at, normal);
      EXPECT_NEAR(Irradiance(panel, V3f(at), V3f(normal), 64), expected,
                  2e-4 * expected);
      EXPECT_NEAR(IrradianceByArea(panel, V3f(at), V3f(normal), 64), expected,
                  1e-3 * expected);
    }
  }
}

// A slanting edge: no rectangle, sampled by area either way.
TEST(QuadLightTest, IrradianceOfAParallelogram) {
  const V3d slant(1, 0, 2);
  const LightData panel = MakeQuad(kCorner, kAcross, slant, Rgb(1));
  ASSERT_FALSE(panel.rectangle);
  const double expected = PanelIrradiance(slant, V3d(0.5, 0, 0), V3d(0, 1, 0));
  EXPECT_NEAR(Irradiance(panel, V3f(0.5f, 0, 0), V3f(0, 1, 0), 64), expected,
              1e-3 * expected);
}

// The midpoint rule is of second order: half the step, a quarter of the error.
TEST(QuadLightTest, QuadratureConvergesAtSecondOrder) {
  const LightData panel = MakeQuad(kCorner, kAcross, kAlong, Rgb(1));
  const double expected = PanelIrradiance(kAlong, V3d(0), V3d(0, 1, 0));
  double error[2][3];
  for (int k = 0; k < 3; ++k) {
    const V3f up(0, 1, 0);
    error[0][k] =
        std::abs(IrradianceByArea(panel, V3f(0), up, 4 << k) - expected);
    error[1][k] = std::abs(Irradiance(panel, V3f(0), up, 4 << k) - expected);
  }
  for (const auto& e : error) {
    EXPECT_NEAR(e[0] / e[1], 4, 0.4);
    EXPECT_NEAR(e[1] / e[2], 4, 0.4);
  }
}

TEST(QuadLightTest, SolidAngleSamplesHaveNoVarianceOfTheirOwn) {
  const LightData panel = MakeQuad(kCorner, kAcross, kAlong, Rgb(1));
  const float first = SampleLight(panel, V3f(0), V2f(0.5f)).irradiance.x;
  MeanOverSquare(8, [&](const V2f& u) {
    EXPECT_EQ(SampleLight(panel, V3f(0), u).irradiance.x, first);
    return 0;
  });
  // The unit cube's face from the center: a sixth of 4 pi.
  const LightData face =
      MakeQuad(V3d(-1, 1, -1), V3d(2, 0, 0), V3d(0, 0, 2), Rgb(1));
  EXPECT_NEAR(SampleLight(face, V3f(0), V2f(0)).irradiance.x, 4 * kPiExact / 6,
              1e-6);
}

/// Solid angle of a triangle: van Oosterom and Strackee, "The Solid Angle of a
/// Plane Triangle", IEEE TBME 30(2), 1983, equation 8.
double TriangleSolidAngle(const V3d& a, const V3d& b, const V3d& c) {
  const double la = a.length(), lb = b.length(), lc = c.length();
  return std::abs(
      2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc +
                                            b.dot(c) * la + c.dot(a) * lb));
}

// The strip up to the sampled abscissa holds the share u of the solid angle,
// also far off the axis, at grazing height and for thin rectangles.
TEST(QuadLightTest, RectanglesAreSampledUniformlyBySolidAngle) {
  struct Case {
    V3d corner, e0, e1;
  };
  const Case cases[] = {{{-1, 2, -1}, {3, 0, 0}, {0, 0, 2}},
                        {{5, 1, -1}, {6, 0, 0}, {0, 0, 9}},
                        {{0.1, 0.01, -3}, {8, 0, 0}, {0, 0, 7}},
                        {{-4, 0.001, -4}, {8, 0, 0}, {0, 0, 8}},
                        {{-50, 1, 0.1}, {100, 0, 0}, {0, 0, 0.05}}};
  for (const Case& c : cases) {
    const LightData light = MakeQuad(c.corner, c.e0, c.e1, Rgb(1));
    const double whole =
        TriangleSolidAngle(c.corner, c.corner + c.e0, c.corner + c.e0 + c.e1) +
        TriangleSolidAngle(c.corner, c.corner + c.e0 + c.e1, c.corner + c.e1);
    for (const float u : {0.0f, 0.1f, 0.5f, 0.93f}) {
      const LightSample s = SampleLight(light, V3f(0), V2f(u, 0.4f));
      EXPECT_NEAR(s.irradiance.x, whole, 5e-5 * whole);
      const V3f p = s.direction * s.distance;
      const V3d part(p.x - c.corner.x, 0, 0);
      const V3d far_corner = c.corner + part + c.e1;
      const double strip =
          TriangleSolidAngle(c.corner, c.corner + part, far_corner) +
          TriangleSolidAngle(c.corner, far_corner, c.corner + c.e1);
      EXPECT_NEAR(strip / whole, u, 2e-3) << c.corner << " " << u;
      EXPECT_NEAR(p.y, c.corner.y, 1e-5);
      EXPECT_GE(p.z, c.corner.z - 1e-4);
      EXPECT_LE(p.z, c.corner.z + c.e1.z + 1e-4);
    }
  }
}

TEST(QuadLightTest, ItsBackIsBlack) {
  const LightData panel = MakeQuad(kCorner, kAcross, kAlong, Rgb(3));
  const V3f above(0, 3, 0);
  EXPECT_EQ(SampleLight(panel, above, V2f(0.5f)).irradiance, Rgb(0));
  EXPECT_EQ(SampleLightByArea(panel, above, V2f(0.5f)).irradiance, Rgb(0));
  const V3f down(0, -1, 0);
  EXPECT_EQ(LightPdf(panel, above, down, 1), 0);
  EXPECT_EQ(EmittedRadiance(panel, down, panel.direction), Rgb(0));
  EXPECT_EQ(EmittedRadiance(panel, -down, panel.direction), Rgb(3));
  // In its plane.
  EXPECT_EQ(SampleLight(panel, V3f(5, 2, 0), V2f(0.5f)).irradiance, Rgb(0));
}

// Lambert's formula for a triangle; the same from its other side.
TEST(TriangleLightTest, ShinesOnBothSides) {
  const V3d a(-1, 2, -1), b(2, 2, 0), c(0, 3, 2);
  const LightData light = TriangleLight(V3f(a), V3f(b), V3f(c), Rgb(2));
  const std::array<V3d, 3> vertices = {a, b, c};
  const double below =
      std::abs(2 * PolygonIrradiance(vertices, V3d(0), V3d(0, 1, 0)));
  EXPECT_NEAR(Irradiance(light, V3f(0), V3f(0, 1, 0), 128), below,
              2e-3 * below);
  const double above =
      std::abs(2 * PolygonIrradiance(vertices, V3d(0, 6, 0), V3d(0, -1, 0)));
  EXPECT_NEAR(Irradiance(light, V3f(0, 6, 0), V3f(0, -1, 0), 128), above,
              2e-3 * above);
  EXPECT_EQ(EmittedRadiance(light, light.direction, light.direction), Rgb(2));
  EXPECT_EQ(EmittedRadiance(light, -light.direction, light.direction), Rgb(2));
}

}  // namespace
}  // namespace rtb
