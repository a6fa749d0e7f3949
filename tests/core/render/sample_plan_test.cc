#include "core/render/sample_plan.h"

#include <gtest/gtest.h>

#include "core/render/camera_rays.h"
#include "core/render/fragments.h"

namespace rtb {
namespace {

TEST(SamplePlanTest, RegularPatternRunsRowByRow) {
  const SamplePlan plan = RegularPlan({3, 2}, 2, 4);
  EXPECT_TRUE(plan.uniform());
  EXPECT_EQ(plan.samples_per_cell, 8);
  EXPECT_EQ(plan.position(5, 0), V2f(0.25f, 0.125f));
  EXPECT_EQ(plan.position(5, 1), V2f(0.75f, 0.125f));
  EXPECT_EQ(plan.position(0, 6), V2f(0.25f, 0.875f));
  EXPECT_EQ(plan.footprint, V2f(0.5f, 0.25f));
}

TEST(SamplePlanTest, PositionsMayDifferFromCellToCell) {
  SamplePlan plan;
  plan.grid = {2, 1};
  plan.samples_per_cell = 2;
  plan.positions = {V2f(0, 0), V2f(0, 0.5f), V2f(0.25f, 0), V2f(0.25f, 0.5f)};
  EXPECT_FALSE(plan.uniform());
  EXPECT_EQ(plan.position(1, 0), V2f(0.25f, 0));
}

TEST(SamplePlanTest, AsksForTheListedCellsAlone) {
  SamplePlan plan = RegularPlan({3, 2}, 2, 1);
  EXPECT_EQ(plan.entries(), 6);
  EXPECT_EQ(plan.cell(4), 4);
  EXPECT_EQ(plan.number(4, 1), 1);
  plan.cells = {5, 2, 5};
  EXPECT_EQ(plan.entries(), 3);
  EXPECT_EQ(plan.samples(), 6u);
  EXPECT_EQ(plan.cell(0), 5);
  EXPECT_EQ(plan.number(2, 1), 1);
  plan.samples_before = {0, 0, 2};
  EXPECT_EQ(plan.number(2, 1), 3);
  EXPECT_EQ(Fragments(plan).values.size(), 6u);
}

TEST(SamplePlanTest, AspectOfThePicture) {
  EXPECT_DOUBLE_EQ(RegularPlan({120, 40}, 1, 1).aspect(), 1.5);
  EXPECT_DOUBLE_EQ(PixelPlan(960, 640).aspect(), 1.5);
}

TEST(FragmentsTest, CellsFollowEachOther) {
  Fragments fragments(RegularPlan({2, 2}, 1, 3));
  EXPECT_EQ(fragments.values.size(), 12u);
  fragments.cell(2)[1] = Rgb(7);
  EXPECT_EQ(fragments.values[7], Rgb(7));
}

TEST(EyeRayTest, PixelCentersSpanTheFieldOfView) {
  // vfov 90: the image plane at distance 1 is 2 high, 4 wide at aspect 2.
  CameraFrame frame;
  frame.position = V3d(1, 2, 3);
  frame.forward = V3d(0, 0, -1);
  frame.right = V3d(1, 0, 0);
  frame.up = V3d(0, 1, 0);
  frame.tan_half_vfov = 1;
  const CameraRays camera = MakeCameraRays(frame, 2);
  const Ray corner = EyeRay(camera, 0, 0);
  EXPECT_EQ(corner.origin, V3f(1, 2, 3));
  EXPECT_LT((corner.direction - V3f(-2, 1, -1).normalized()).length(), 1e-6f);
  EXPECT_EQ(EyeRay(camera, 0.5, 0.5).direction, V3f(0, 0, -1));
  EXPECT_LT((EyeRay(camera, 0.75, 1).direction - V3f(1, -1, -1).normalized())
                .length(),
            1e-6f);
}

}  // namespace
}  // namespace rtb
