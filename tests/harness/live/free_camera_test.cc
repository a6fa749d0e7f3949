#include "harness/live/free_camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rtb {
namespace {

CameraFrame Looking(const V3d& forward) {
  const V3d up = std::abs(forward.y) > 0.99 ? V3d(0, 0, -1) : V3d(0, 1, 0);
  const V3d right = forward.cross(up).normalized();
  return {V3d(1, 2, 3), right, right.cross(forward), forward, 0.5};
}

void ExpectNear(const V3d& a, const V3d& b, double tolerance) {
  EXPECT_LT((a - b).length(), tolerance) << a << " " << b;
}

const V3d kUp(0, 1, 0);

TEST(FreeCamera, BeginsAsTheFrameThatItIsGiven) {
  const CameraFrame frame = Looking(V3d(0.6, 0, -0.8));
  const CameraFrame moved = FreeCamera(frame, kUp, 1).frame();
  ExpectNear(moved.position, frame.position, 1e-12);
  ExpectNear(moved.forward, frame.forward, 1e-12);
  ExpectNear(moved.right, frame.right, 1e-12);
  ExpectNear(moved.up, frame.up, 1e-12);
  EXPECT_EQ(moved.tan_half_vfov, 0.5);
}

TEST(FreeCamera, WalkingDoesNotDependOnTheFrameRate) {
  // A second of walking and half a second of coming to rest.
  const auto walk = [](int steps_per_second) {
    FreeCamera camera(Looking(V3d(0, 0, -1)), kUp, 2);
    MotionInput forward;
    forward.forward = 1;
    const double step = 1.0 / steps_per_second;
    for (int i = 0; i < steps_per_second; ++i) camera.Step(forward, step);
    for (int i = 0; i < steps_per_second / 2; ++i) camera.Step({}, step);
    return camera.frame().position;
  };
  const V3d slow = walk(10);
  ExpectNear(slow, walk(144), 1e-9);
  // What the start lacks in speed the end makes up for: 2 units.
  ExpectNear(slow, V3d(1, 2, 1), 0.01);
}

TEST(FreeCamera, HurriesAndSettles) {
  FreeCamera camera(Looking(V3d(0, 0, -1)), kUp, 1);
  MotionInput input;
  input.right = 1;
  input.hurry = true;
  EXPECT_FALSE(camera.moving());
  camera.Step(input, 1);
  EXPECT_TRUE(camera.moving());
  EXPECT_GT(camera.frame().position.x, 1 + 3);
  camera.Step({}, 2);
  EXPECT_FALSE(camera.moving());
}

TEST(FreeCamera, NeverLooksOverTheTop) {
  FreeCamera camera(Looking(V3d(0, 0, -1)), kUp, 1);
  for (int i = 0; i < 100; ++i) camera.Look(0.1, 1);
  const CameraFrame frame = camera.frame();
  EXPECT_GT(frame.up.y, 0);
  EXPECT_NEAR(frame.forward.length(), 1, 1e-12);
  EXPECT_NEAR(frame.right.y, 0, 1e-12);
  EXPECT_NEAR(frame.forward.dot(frame.right), 0, 1e-12);
}

TEST(FreeCamera, StartsLookingStraightDown) {
  const CameraFrame frame = FreeCamera(Looking(V3d(0, -1, 0)), kUp, 1).frame();
  EXPECT_LT(frame.forward.y, -0.99);
  EXPECT_NEAR(frame.right.length(), 1, 1e-9);
}

TEST(FreeCamera, StaysFinite) {
  FreeCamera camera(Looking(V3d(0, 0, -1)), kUp, 1e300);
  MotionInput input;
  input.forward = 1;
  input.up = 1;
  for (int i = 0; i < 10; ++i) camera.Step(input, 1e9);
  const V3d position = camera.frame().position;
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_TRUE(std::isfinite(position[axis]));
    EXPECT_LE(std::abs(position[axis]), 1e7);
  }
}

TEST(FreeCamera, OrbitKeepsTheDistance) {
  FreeCamera camera(Looking(V3d(0, 0, -1)), kUp, 1);
  camera.Orbit(1.5, 4);
  const CameraFrame frame = camera.frame();
  // The center was (1, 2, -1).
  ExpectNear(frame.position + frame.forward * 4.0, V3d(1, 2, -1), 1e-9);
  EXPECT_GT((frame.position - V3d(1, 2, 3)).length(), 1);
}

TEST(FreeCamera, ZoomHasEnds) {
  FreeCamera camera(Looking(V3d(0, 0, -1)), kUp, 1);
  camera.Zoom(-1000);
  EXPECT_GT(camera.frame().tan_half_vfov, 0);
  camera.Zoom(10000);
  EXPECT_LE(camera.frame().tan_half_vfov, 4);
}

}  // namespace
}  // namespace rtb
