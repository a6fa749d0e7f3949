#include "core/shading/ray_cone.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rtb {
namespace {

/// A plane z = 0 of which u takes 2 units and v 4.
SurfaceUv Plane() { return {V2f(0, 0), V3f(2, 0, 0), V3f(0, 4, 0)}; }

const V3f kUp(0, 0, 1);

TEST(RayConeTest, WidensAlongItsRay) {
  const RayCone cone = RayCone{0.5f, 0.125f}.At(4);
  EXPECT_EQ(cone.width, 1);
  EXPECT_EQ(cone.spread, 0.125f);
}

// Straight down: a disk 1 wide is 1/2 of u and 1/4 of v.
TEST(RayConeTest, SeesADiskFromAbove) {
  const UvFootprint seen = FootprintOf(Plane(), kUp, V3f(0, 0, -1), 1);
  // Any two diameters at right angles: the squares along u, and along v, add.
  EXPECT_NEAR(seen.a.x * seen.a.x + seen.b.x * seen.b.x, 0.25f, 1e-6f);
  EXPECT_NEAR(seen.a.y * seen.a.y + seen.b.y * seen.b.y, 0.0625f, 1e-6f);
  EXPECT_NEAR(seen.a.x * seen.a.y + seen.b.x * seen.b.y, 0, 1e-6f);
}

// 60 degrees off the normal in the plane of x and z: 1 / cos 60 = 2 times as
// long along x, so 1 of u and 1/4 of v; from either side.
TEST(RayConeTest, SeesAnEllipseAtASlant) {
  for (const float side : {1.0f, -1.0f}) {
    const V3f direction(std::sqrt(0.75f), 0, -0.5f * side);
    const UvFootprint seen = FootprintOf(Plane(), kUp, direction, 1);
    EXPECT_NEAR(std::abs(seen.a.x), 1, 1e-5f);
    EXPECT_NEAR(seen.a.y, 0, 1e-6f);
    EXPECT_NEAR(seen.b.x, 0, 1e-6f);
    EXPECT_NEAR(std::abs(seen.b.y), 0.25f, 1e-6f);
  }
}

// Axes of a sheared texture: p = u (1, 0) + v (1, 1), so that (x, y) = (1, 0)
// is u = 1, and (0, 1) is u = -1, v = 1.
TEST(RayConeTest, FollowsShearedCoordinates) {
  const SurfaceUv sheared{V2f(0, 0), V3f(1, 0, 0), V3f(1, 1, 0)};
  const V3f along_x = V3f(1, 0, -1e-2f).normalized();
  const UvFootprint seen = FootprintOf(sheared, kUp, along_x, 0.5f);
  EXPECT_NEAR(std::abs(seen.a.x), 50, 0.01f);
  EXPECT_NEAR(seen.a.y, 0, 1e-3f);
  EXPECT_NEAR(std::abs(seen.b.x), 0.5f, 1e-3f);
  EXPECT_NEAR(seen.b.y, -seen.b.x, 1e-3f);
}

TEST(RayConeTest, IsAPointWithoutWidthOrArea) {
  const UvFootprint none = FootprintOf(Plane(), kUp, V3f(0, 0, -1), 0);
  EXPECT_EQ(none.a, V2f(0, 0));
  EXPECT_EQ(none.b, V2f(0, 0));
  const SurfaceUv flat{V2f(0, 0), V3f(1, 0, 0), V3f(2, 0, 0)};
  EXPECT_EQ(FootprintOf(flat, kUp, V3f(0, 0, -1), 1).a, V2f(0, 0));
}

// Seen edge-on it is long, but a number.
TEST(RayConeTest, EndsEdgeOn) {
  const UvFootprint seen = FootprintOf(Plane(), kUp, V3f(1, 0, 0), 1);
  EXPECT_NEAR(std::abs(seen.a.x), 500, 0.1f);
}

}  // namespace
}  // namespace rtb
