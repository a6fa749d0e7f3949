#include "core/math/affine.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rtb {
namespace {

constexpr double kTolerance = 1e-12;

void ExpectNear(const V3d& a, const V3d& b, double tolerance = kTolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

Affined Rotation(double x, double y, double z) {
  return PositionRotateScale(V3d(0), V3d(x, y, z), V3d(1));
}

/// Rodrigues' formula: v turned right-handed about the unit vector `axis`.
V3d Turned(const V3d& v, const V3d& axis, double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return v * std::cos(angle) + axis.cross(v) * std::sin(angle) +
         axis * axis.dot(v) * (1 - std::cos(angle));
}

const Affined kSome =
    PositionRotateScale(V3d(1, -2, 3), V3d(20, -35, 130), V3d(2, 0.5, -3));

TEST(Affine, DefaultIsTheIdentity) {
  EXPECT_EQ(Affined().Point(V3d(1, 2, 3)), V3d(1, 2, 3));
  EXPECT_EQ(Affined().Determinant(), 1);
}

// Right-handed, counterclockwise seen from the tip of the axis; exact.
TEST(Affine, QuarterTurns) {
  EXPECT_EQ(Rotation(0, 0, 90).Point(V3d(1, 0, 0)), V3d(0, 1, 0));
  EXPECT_EQ(Rotation(90, 0, 0).Point(V3d(0, 1, 0)), V3d(0, 0, 1));
  EXPECT_EQ(Rotation(0, 90, 0).Point(V3d(0, 0, 1)), V3d(1, 0, 0));
  EXPECT_EQ(Rotation(0, 0, -270).Point(V3d(1, 0, 0)), V3d(0, 1, 0));
  EXPECT_EQ(Rotation(0, 0, 450).Point(V3d(1, 0, 0)), V3d(0, 1, 0));
  EXPECT_EQ(Rotation(0, 0, 180).Point(V3d(1, 2, 3)), V3d(-1, -2, 3));
  EXPECT_EQ(Rotation(0, 0, 360).Point(V3d(1, 2, 3)), V3d(1, 2, 3));
}

// First about x, then y, then z: x takes y to z, and y takes z to x. The
// opposite order would leave y at z.
TEST(Affine, TurnsAboutXThenYThenZ) {
  EXPECT_EQ(Rotation(90, 90, 0).Point(V3d(0, 1, 0)), V3d(1, 0, 0));
  EXPECT_EQ(Rotation(90, 90, 90).Point(V3d(0, 1, 0)), V3d(0, 1, 0));
}

TEST(Affine, AgreesWithRodrigues) {
  const V3d position(1, -2, 3), degrees(20, -35, 130), scale(2, 0.5, -3);
  for (const V3d& p :
       {V3d(1, 0, 0), V3d(0, 1, 0), V3d(0, 0, 1), V3d(0.3, -4, 2)}) {
    V3d expected = p * scale;
    expected = Turned(expected, V3d(1, 0, 0), degrees.x);
    expected = Turned(expected, V3d(0, 1, 0), degrees.y);
    expected = Turned(expected, V3d(0, 0, 1), degrees.z);
    ExpectNear(kSome.Direction(p), expected);
    ExpectNear(kSome.Point(p), expected + position);
  }
  // A rotation keeps volumes, so this is the product of the scales.
  EXPECT_NEAR(kSome.Determinant(), 2 * 0.5 * -3, kTolerance);
}

TEST(Affine, InverseUndoes) {
  const Affined inverse = kSome.Inverse();
  const V3d p(0.3, -4, 2);
  ExpectNear(inverse.Point(kSome.Point(p)), p);
  ExpectNear(kSome.Point(inverse.Point(p)), p);
  ExpectNear(inverse.Direction(kSome.Direction(p)), p);
}

TEST(Affine, ProductAppliesTheRightOneFirst) {
  const Affined other =
      PositionRotateScale(V3d(5, 0, -1), V3d(0, 45, 10), V3d(1, 2, 3));
  const V3d p(0.3, -4, 2);
  ExpectNear((kSome * other).Point(p), kSome.Point(other.Point(p)));
  ExpectNear((kSome * other).Direction(p), kSome.Direction(other.Direction(p)));
}

// A normal stays perpendicular to what it was perpendicular to.
TEST(Affine, TransposedInverseMapsNormals) {
  const V3d normal(1, 2, -1), tangent(2, -1, 0);
  ASSERT_EQ(normal.dot(tangent), 0);
  EXPECT_NEAR(kSome.Inverse().Transposed(normal).dot(kSome.Direction(tangent)),
              0, kTolerance);
}

TEST(Affine, ToFloatKeepsTheMap) {
  const V3d p(0.3, -4, 2);
  ExpectNear(V3d(ToFloat(kSome).Point(V3f(p))), kSome.Point(p), 1e-5);
}

}  // namespace
}  // namespace rtb
