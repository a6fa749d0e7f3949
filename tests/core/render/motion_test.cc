#include "core/render/motion.h"

#include <gtest/gtest.h>

#include "tests/core/render/scenes.h"

namespace rtb {
namespace {

using testing::SceneBuilder;

constexpr int kSide = 10;

/// A picture of 10 x 10 pixels that shows x and y from -1 to 1 at distance 1:
/// a unit is 5 pixels there, and 2.5 at distance 2.
class MotionTest : public ::testing::Test {
 protected:
  MotionTest() {
    builder_.scene.camera.vfov = 90;
    // Path 0 leads from the origin to (0.4, 0, 0) in one second.
    builder_.scene.paths = {{"right",
                             {V3d(0), V3d(0.4, 0, 0)},
                             {0, 1},
                             1,
                             false,
                             Path::Interpolation::kLinear}};
  }

  /// A wall of 100 x 100 at distance 2.
  Object& AddWall() {
    return builder_.Add(
        Quad{V3d(-50, -50, -2), {V3d(100, 0, 0), V3d(0, 100, 0)}},
        builder_.Add(Lambertian{}));
  }

  /// The motion from time 1 back to time 0.
  std::vector<PixelMotion> Trace() const {
    const auto now = Moment::Make(builder_.scene, 1, 1).value();
    const auto before = Moment::Make(builder_.scene, 0, 1).value();
    return TraceMotion(*now, *before, kSide, kSide, 1);
  }

  static const PixelMotion& At(const std::vector<PixelMotion>& motions, int x,
                               int y) {
    return motions[static_cast<std::size_t>(y * kSide + x)];
  }

  static void ExpectPlace(const PixelMotion& motion, double x, double y) {
    EXPECT_EQ(motion.sight, Sight::kVisible);
    EXPECT_NEAR(motion.place.x, x, 1e-4);
    EXPECT_NEAR(motion.place.y, y, 1e-4);
  }

  SceneBuilder builder_;
};

TEST_F(MotionTest, WhatStandsStillStaysWhereItIs) {
  AddWall();
  const auto motions = Trace();
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      ExpectPlace(At(motions, x, y), x + 0.5, y + 0.5);
    }
  }
}

// The wall was 0.4 further left: 1 pixel at distance 2. What is in the first
// column now was outside.
TEST_F(MotionTest, FollowsAnObject) {
  AddWall().path = 0;
  const auto motions = Trace();
  for (int y = 0; y < kSide; ++y) {
    for (int x = 1; x < kSide; ++x) {
      ExpectPlace(At(motions, x, y), x - 0.5, y + 0.5);
    }
    EXPECT_EQ(At(motions, 0, y).sight, Sight::kOutside);
  }
  // The center of pixel (5, 5) is at (0.1, -0.1) 1 away, at twice that 2 away.
  const V3d then = At(motions, 5, 5).point;
  // Single precision, of coordinates up to 50.
  EXPECT_NEAR((then - V3d(0.2 - 0.4, -0.2, -2)).length(), 0, 2e-5);
}

// The camera was 0.4 further left: everything was further right.
TEST_F(MotionTest, FollowsTheCamera) {
  AddWall();
  builder_.scene.camera.path = 0;
  const auto motions = Trace();
  for (int x = 0; x < kSide - 1; ++x) {
    ExpectPlace(At(motions, x, 4), x + 1.5, 4.5);
  }
  EXPECT_EQ(At(motions, kSide - 1, 4).sight, Sight::kOutside);
}

// An instance in a group that moves, turned and scaled.
TEST_F(MotionTest, FollowsWhatIsInsideAGroup) {
  Object& wall = AddWall();
  wall.rotate = V3d(0, 0, 30);
  Object group;
  group.shape = Group{};
  group.path = 0;
  group.scale = V3d(2, 2, 1);
  group.children = {wall};
  builder_.scene.objects = {group};
  ExpectPlace(At(Trace(), 5, 5), 4.5, 5.5);
}

// A panel of 0.8 x 0.8 at distance 1 (4 x 4 pixels) goes 0.4 (2 pixels) to the
// right, from columns 1-4 to 3-6. What it leaves behind, the wall in columns 1
// and 2, was hidden; beside it the wall has always been seen.
TEST_F(MotionTest, TellsWhatWasHidden) {
  AddWall();
  builder_
      .Add(Quad{V3d(-0.8, -0.4, -1), {V3d(0.8, 0, 0), V3d(0, 0.8, 0)}},
           builder_.Add(Lambertian{}))
      .path = 0;
  const auto motions = Trace();
  for (int x = 0; x < kSide; ++x) {
    SCOPED_TRACE(x);
    const PixelMotion& motion = At(motions, x, 5);
    if (x == 1 || x == 2) {
      EXPECT_EQ(motion.sight, Sight::kHidden);
      EXPECT_NEAR(motion.place.x, x + 0.5, 1e-4);
    } else {
      ExpectPlace(motion, x >= 3 && x <= 6 ? x - 1.5 : x + 0.5, 5.5);
    }
  }
}

// Infinitely far away, the background does not follow a camera that moves
// without turning; where a panel stood it was hidden.
TEST_F(MotionTest, TheBackgroundIsInfinitelyFarAway) {
  builder_.scene.camera.path = 0;
  builder_.Add(Quad{V3d(0.4, -0.4, -1), {V3d(0.8, 0, 0), V3d(0, 0.8, 0)}},
               builder_.Add(Lambertian{}));
  const auto motions = Trace();
  ExpectPlace(At(motions, 1, 5), 1.5, 5.5);
  // From x = 0 the panel covered columns 7 to 10, from 0.4 columns 5 to 8.
  EXPECT_EQ(At(motions, 9, 5).sight, Sight::kHidden);
  ExpectPlace(At(motions, 5, 5), 7.5, 5.5);
  EXPECT_NEAR(At(motions, 1, 5).point.length(), 1, 1e-6);
}

TEST_F(MotionTest, DoesNotDependOnThreads) {
  AddWall().path = 0;
  const auto now = Moment::Make(builder_.scene, 1, 1).value();
  const auto before = Moment::Make(builder_.scene, 0.3, 1).value();
  const auto one = TraceMotion(*now, *before, kSide, kSide, 1);
  const auto three = TraceMotion(*now, *before, kSide, kSide, 3);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].place, three[i].place);
    EXPECT_EQ(one[i].sight, three[i].sight);
  }
}

}  // namespace
}  // namespace rtb
