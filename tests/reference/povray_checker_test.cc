/// @file
/// The checker as POV-Ray draws it, against the definition of the format.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/reference/pov_pixels.h"

namespace rtb {
namespace {

/// 1 where the format's checker of cells `size` is even at p + n size / 1000.
double Even(const V3d& p, const V3d& n, double size) {
  const V3d q = p / size + n * 0.001;
  const double sum = std::floor(q.x) + std::floor(q.y) + std::floor(q.z);
  return std::fmod(std::abs(sum), 2) == 0 ? 1 : 0;
}

TEST(PovRayTest, CheckerOnCellBordersLooksOutwards) {
  SKIP_WITHOUT_POVRAY();
  // The wall z = -2 lies on a cell border; seen against its normal +z, and,
  // for a wall with normal -z, from behind.
  for (const double facing : {1.0, -1.0}) {
    Scene scene = MakeScene();
    AddObject(&scene, Plane{V3d(0, 0, -2), V3d(0, 0, facing)},
              GlowingChecker(&scene, 0.5));
    ExpectEverywhere(Pixels(scene, 48, 32), kHalf, [&](const V3d& d) {
      return V3d(Even(d * (-2 / d.z), V3d(0, 0, facing), 0.5));
    });
  }
}

TEST(PovRayTest, CheckerOnASphereLooksOutwards) {
  SKIP_WITHOUT_POVRAY();
  Scene scene = MakeScene();
  const V3d center(0.1, 0.2, -4);
  AddObject(&scene, Sphere{center, 1.3}, GlowingChecker(&scene, 0.25));
  const Image image = Pixels(scene, 480, 320);
  int hits = 0, wrong = 0;
  for (int y = 0; y < 320; ++y) {
    for (int x = 0; x < 480; ++x) {
      const V3d d = Direction(image, x, y);
      const double b = d.dot(center);
      const double q = b * b - center.length2() + 1.3 * 1.3;
      if (q < 1e-6) continue;
      const V3d p = d * (b - std::sqrt(q));
      ++hits;
      if (image.at(x, y).x != Even(p, (p - center) / 1.3, 0.25)) ++wrong;
    }
  }
  EXPECT_GT(hits, 9000);
  EXPECT_EQ(wrong, 0);
}

TEST(PovRayTest, CheckerLiesInObjectSpace) {
  SKIP_WITHOUT_POVRAY();
  // Turned by 90 degrees about z and moved by (0.31, 0, 0), scaled by 2: world
  // p = (0.31, 0, 0) + 2 (-y, x, z), so object x = p.y / 2 and so on.
  Scene scene = MakeScene();
  Object& wall = AddObject(&scene, Plane{V3d(0, 0, -1.1), V3d(0, 0, 1)},
                           GlowingChecker(&scene, 0.35));
  wall.position = V3d(0.31, 0, 0);
  wall.rotate = V3d(0, 0, 90);
  wall.scale = V3d(2);
  ExpectEverywhere(Pixels(scene, 49, 33), kHalf, [](const V3d& d) {
    const V3d p = d * (-2.2 / d.z) - V3d(0.31, 0, 0);
    return V3d(Even(V3d(p.y, -p.x, p.z) / 2.0, V3d(0, 0, 1), 0.35));
  });
}

}  // namespace
}  // namespace rtb
