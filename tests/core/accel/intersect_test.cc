#include "core/accel/intersect.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rtb {
namespace {

/// A sphere or disk as Geometry holds it.
Geometry Of(const FlatSphere& sphere) {
  FlatScene flat;
  flat.spheres = {sphere};
  return MakeGeometry(flat);
}

FlatSphere SphereAt(const V3d& center, double radius) {
  FlatSphere sphere;
  sphere.unit_to_world =
      PositionRotateScale(center, V3d(0), V3d(radius, radius, radius));
  sphere.object = 0;
  return sphere;
}

TEST(IntersectSphereTest, EntersAndLeaves) {
  const Geometry g = Of(SphereAt(V3d(0, 0, -5), 2));
  const Roots roots =
      IntersectSphere(g.spheres[0], V3f(0, 0, 0), V3f(0, 0, -1));
  ASSERT_EQ(roots.count, 2);
  EXPECT_FLOAT_EQ(roots.t[0], 3);
  EXPECT_FLOAT_EQ(roots.t[1], 7);
}

TEST(IntersectSphereTest, EllipsoidBySemiAxes) {
  // Semi-axes 1, 2, 3: along each axis the roots are at 10 -+ semi-axis.
  FlatSphere ellipsoid;
  ellipsoid.unit_to_world = PositionRotateScale(V3d(0), V3d(0), V3d(1, 2, 3));
  const Geometry g = Of(ellipsoid);
  for (int axis = 0; axis < 3; ++axis) {
    V3f origin(0), direction(0);
    origin[axis] = -10;
    direction[axis] = 1;
    const Roots roots = IntersectSphere(g.spheres[0], origin, direction);
    ASSERT_EQ(roots.count, 2);
    EXPECT_FLOAT_EQ(roots.t[0], 10 - static_cast<float>(axis + 1));
    EXPECT_FLOAT_EQ(roots.t[1], 10 + static_cast<float>(axis + 1));
  }
}

TEST(IntersectSphereTest, SmallAndFarKeepsItsSilhouette) {
  // A unit sphere seen from 1000 radii: rays whose distance to the center is
  // 1 -+ 1e-4 must hit and miss. The textbook b^2 - ac fails this by far.
  const Geometry g = Of(SphereAt(V3d(0), 1));
  for (const double miss : {0.9999, 1.0001}) {
    const double sine = miss / 1000;
    const V3f direction(static_cast<float>(sine), 0,
                        static_cast<float>(-std::sqrt(1 - sine * sine)));
    const Roots roots =
        IntersectSphere(g.spheres[0], V3f(0, 0, 1000), direction);
    EXPECT_EQ(roots.count, miss < 1 ? 2 : 0) << miss;
  }
}

TEST(IntersectSphereTest, BehindTheOriginHasNegativeRoots) {
  const Geometry g = Of(SphereAt(V3d(0, 0, 5), 1));
  const Roots roots =
      IntersectSphere(g.spheres[0], V3f(0, 0, 0), V3f(0, 0, -1));
  ASSERT_EQ(roots.count, 2);
  EXPECT_LT(roots.t[1], 0);
}

TEST(IntersectDiskTest, RimDecides) {
  FlatScene flat;
  FlatDisk disk;
  disk.unit_to_world = PositionRotateScale(V3d(0, 0, -4), V3d(0), V3d(2, 2, 2));
  flat.disks = {disk};
  const Geometry g = MakeGeometry(flat);
  const V3f down(0, 0, -1);
  EXPECT_EQ(IntersectDisk(g.disks[0], V3f(1.999f, 0, 0), down).count, 1);
  EXPECT_EQ(IntersectDisk(g.disks[0], V3f(2.001f, 0, 0), down).count, 0);
  EXPECT_FLOAT_EQ(IntersectDisk(g.disks[0], V3f(0, 0, 0), down).t[0], 4);
  EXPECT_EQ(IntersectDisk(g.disks[0], V3f(0), V3f(1, 0, 0)).count, 0);
}

TEST(IntersectPlaneTest, SlopeAndParallel) {
  const PlaneData plane{V3f(0, -1, 0), V3f(0, 1, 0), 0};
  const V3f slanted = V3f(0, -3, -4) / 5;
  EXPECT_FLOAT_EQ(IntersectPlane(plane, V3f(0, 2, 0), slanted).t[0], 5);
  EXPECT_EQ(IntersectPlane(plane, V3f(0, 2, 0), V3f(0, 0, -1)).count, 0);
}

}  // namespace
}  // namespace rtb
