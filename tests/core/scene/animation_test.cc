#include "core/scene/animation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rtb {
namespace {

Path Zigzag(bool loop, Path::Interpolation interpolation) {
  // Three points; equal times over 6 s: two segments open, three looping.
  const double step = loop ? 2 : 3;
  return {"zigzag",
          {V3d(0, 0, 0), V3d(2, 0, 0), V3d(2, 4, 0)},
          {0, step, 2 * step},
          6,
          loop,
          interpolation};
}

constexpr auto kLinear = Path::Interpolation::kLinear;
constexpr auto kCatmullRom = Path::Interpolation::kCatmullRom;

TEST(PathOffsetTest, LinearSegmentsTakeEqualTime) {
  const Path path = Zigzag(false, kLinear);
  EXPECT_EQ(PathOffset(path, 0), V3d(0, 0, 0));
  EXPECT_EQ(PathOffset(path, 1.5), V3d(1, 0, 0));
  EXPECT_EQ(PathOffset(path, 3), V3d(2, 0, 0));
  EXPECT_EQ(PathOffset(path, 4.5), V3d(2, 2, 0));
}

TEST(PathOffsetTest, OpenPathStaysAtItsEnds) {
  const Path path = Zigzag(false, kLinear);
  EXPECT_EQ(PathOffset(path, 6), V3d(2, 4, 0));
  EXPECT_EQ(PathOffset(path, 1e9), V3d(2, 4, 0));
  EXPECT_EQ(PathOffset(path, -1), V3d(0, 0, 0));
}

TEST(PathOffsetTest, LoopReturnsWithinTheDurationAndWraps) {
  const Path path = Zigzag(true, kLinear);
  EXPECT_EQ(PathOffset(path, 5), V3d(1, 2, 0));  // half way home
  EXPECT_EQ(PathOffset(path, 6), V3d(0, 0, 0));
  EXPECT_EQ(PathOffset(path, 7), PathOffset(path, 1));
  EXPECT_EQ(PathOffset(path, -1), PathOffset(path, 5));
}

TEST(PathOffsetTest, CatmullRomGoesThroughAllPoints) {
  for (const bool loop : {false, true}) {
    const Path path = Zigzag(loop, kCatmullRom);
    for (std::size_t i = 0; i < path.points.size(); ++i) {
      EXPECT_LT((PathOffset(path, path.times[i]) - path.points[i]).length(),
                1e-12);
    }
  }
}

TEST(PathOffsetTest, CatmullRomWithDoubledEnds) {
  // First segment, u = 1/2, points p0 p0 p1 p2: weights of the uniform
  // spline at 1/2 are (-1, 9, 9, -1) / 16, so
  // x = (-0 + 9*0 + 9*2 - 2) / 16 = 1, y = -4 / 16.
  const V3d p = PathOffset(Zigzag(false, kCatmullRom), 1.5);
  EXPECT_NEAR(p.x, 1, 1e-12);
  EXPECT_NEAR(p.y, -0.25, 1e-12);
}

TEST(PathOffsetTest, CatmullRomWrapsWhenLooping) {
  // Same place with p2 before p0: x = (-2 + 18 - 2) / 16, y = (-4 - 4) / 16.
  const V3d p = PathOffset(Zigzag(true, kCatmullRom), 1);
  EXPECT_NEAR(p.x, 14.0 / 16, 1e-12);
  EXPECT_NEAR(p.y, -0.5, 1e-12);
}

TEST(CameraAtTest, RightIsDirectionCrossUp) {
  Scene scene;
  scene.camera.position = V3d(278, 273, -800);
  scene.camera.direction = V3d(0, 0, 2);
  scene.camera.vfov = 90;
  const CameraFrame frame = CameraAt(scene, 0);
  EXPECT_EQ(frame.forward, V3d(0, 0, 1));
  EXPECT_EQ(frame.right, V3d(-1, 0, 0));  // +x is on the picture's left
  EXPECT_EQ(frame.up, V3d(0, 1, 0));
  EXPECT_NEAR(frame.tan_half_vfov, 1, 1e-15);
}

TEST(CameraAtTest, UpIsMadePerpendicular) {
  Scene scene;
  scene.camera.direction = V3d(0, -3, -4);
  const CameraFrame frame = CameraAt(scene, 0);
  EXPECT_NEAR(frame.up.dot(frame.forward), 0, 1e-15);
  EXPECT_NEAR(frame.up.y, 0.8, 1e-15);
}

TEST(CameraAtTest, PathsMovePositionAndTarget) {
  Scene scene;
  scene.paths = {{"a", {V3d(0), V3d(0, 0, 2)}, {0, 1}, 1, false, kLinear},
                 {"b", {V3d(0), V3d(2, 0, 0)}, {0, 1}, 1, false, kLinear}};
  scene.camera.has_look_at = true;
  scene.camera.look_at = V3d(0, 0, -1);
  scene.camera.path = 0;
  scene.camera.look_path = 1;
  const CameraFrame frame = CameraAt(scene, 1);
  EXPECT_EQ(frame.position, V3d(0, 0, 2));
  EXPECT_NEAR(frame.forward.x, 2 / std::sqrt(13.0), 1e-15);
  EXPECT_NEAR(frame.forward.z, -3 / std::sqrt(13.0), 1e-15);
}

TEST(CameraAtTest, DegenerateMomentsStayOrthonormal) {
  Scene scene;
  scene.camera.has_look_at = true;
  scene.camera.look_at = scene.camera.position;
  EXPECT_EQ(CameraAt(scene, 0).forward, V3d(0, 0, -1));
  scene.camera.look_at = V3d(0, 5, 0);
  const CameraFrame frame = CameraAt(scene, 0);
  EXPECT_NEAR(frame.right.length(), 1, 1e-15);
  EXPECT_NEAR(frame.right.dot(frame.forward), 0, 1e-15);
}

}  // namespace
}  // namespace rtb
