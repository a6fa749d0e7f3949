#include "harness/live/sample_store.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "harness/live/region_source.h"

namespace rtb {
namespace {

/// Shows a slope: its value is the position in the picture, in cells.
class Slope {
 public:
  Result<Fragments> operator()(const SamplePlan& plan, int pass) {
    rays += plan.samples();
    last_pass = pass;
    Fragments fragments(plan);
    for (int entry = 0; entry < plan.entries(); ++entry) {
      const int cell = plan.cell(entry);
      for (int s = 0; s < plan.samples_per_cell; ++s) {
        const V2f position = plan.position(entry, s);
        fragments.cell(entry)[static_cast<std::size_t>(s)] =
            Rgb(static_cast<float>(cell % plan.grid.columns) + position.x,
                static_cast<float>(cell / plan.grid.columns) + position.y, 0);
      }
    }
    return fragments;
  }

  std::size_t rays = 0;
  int last_pass = -1;
};

const GridSize kGrid{6, 4};

/// The largest distance of a sample's value from its own position.
float Largest(const Fragments& fragments, const SamplePlan& plan) {
  Slope slope;
  const Fragments exact = *slope(plan, 0);
  float largest = 0;
  for (std::size_t i = 0; i < exact.values.size(); ++i) {
    largest =
        std::max(largest, (exact.values[i] - fragments.values[i]).length());
  }
  return largest;
}

class SampleStoreTest : public testing::Test {
 protected:
  Fragments Frame(int epoch, double share) {
    store_.BeginFrame(
        [this](const SamplePlan& plan, int pass) { return slope_(plan, pass); },
        epoch, share, 1);
    auto fragments = store_.Query(plan_);
    EXPECT_TRUE(fragments.has_value());
    return *fragments;
  }

  SamplePlan plan_ = RegularPlan(kGrid, 2, 2);
  Slope slope_;
  SampleStore store_;
};

TEST_F(SampleStoreTest, AllSamplesAtOnceAreExact) {
  EXPECT_EQ(Largest(Frame(1, 1), plan_), 0);
  EXPECT_EQ(store_.traced(), plan_.samples());
  EXPECT_EQ(store_.least_rays(), 1);
}

TEST_F(SampleStoreTest, AtRestTheMeanConvergesToTheFootprints) {
  for (int frame = 0; frame < 256; ++frame) Frame(1, 1);
  EXPECT_EQ(store_.least_rays(), 256);
  // The mean of the slope over a footprint is the value at its middle.
  EXPECT_LT(Largest(Frame(1, 1), plan_), 0.01f);
  // Then it is good enough.
  EXPECT_EQ(store_.traced(), 0u);
  EXPECT_EQ(slope_.last_pass, 255);
}

TEST_F(SampleStoreTest, AQuarterIsOneSampleForEachCell) {
  const Fragments fragments = Frame(1, 0.25);
  EXPECT_EQ(store_.traced(), static_cast<std::size_t>(kGrid.cells()));
  EXPECT_EQ(store_.least_rays(), 0);
  // The others show one of the same cell: at most the cell's diagonal of
  // samples away, sqrt(2) / 2.
  EXPECT_LE(Largest(fragments, plan_), 0.7072f);
}

TEST_F(SampleStoreTest, FourQuartersAreAll) {
  for (int frame = 0; frame < 3; ++frame) {
    EXPECT_GT(Largest(Frame(1, 0.25), plan_), 0);
  }
  EXPECT_EQ(Largest(Frame(1, 0.25), plan_), 0);
  EXPECT_EQ(store_.least_rays(), 1);
  EXPECT_EQ(slope_.rays, plan_.samples());
}

TEST_F(SampleStoreTest, AnotherEpochForgets) {
  for (int frame = 0; frame < 4; ++frame) Frame(1, 0.25);
  EXPECT_GT(Largest(Frame(2, 0.25), plan_), 0);
  EXPECT_EQ(store_.least_rays(), 0);
}

TEST_F(SampleStoreTest, OneRayForFourCellsShowsNeighbors) {
  const Fragments fragments = Frame(1, 1.0 / 16);
  EXPECT_EQ(store_.traced(), static_cast<std::size_t>(kGrid.cells()) / 4);
  // Within the block of 2 x 2 cells: less than its diagonal.
  EXPECT_LT(Largest(fragments, plan_), 2.83f);
}

TEST_F(SampleStoreTest, TinyGridsAreAlwaysCovered) {
  for (const GridSize grid : {GridSize{1, 1}, GridSize{1, 5}, GridSize{3, 1},
                              GridSize{2, 2}, GridSize{3, 3}}) {
    plan_ = RegularPlan(grid, 2, 2);
    for (int frame = 0; frame < 5; ++frame) {
      const Fragments fragments = Frame(frame, 1.0 / 16);
      EXPECT_GT(store_.traced(), 0u);
      EXPECT_LT(Largest(fragments, plan_), 4.3f);
    }
  }
}

TEST_F(SampleStoreTest, FurtherPlansOfAFrameArePassedOn) {
  Frame(1, 0.25);
  SamplePlan round = plan_;
  round.cells = {3, 5};
  const auto fragments = store_.Query(round);
  ASSERT_TRUE(fragments.has_value());
  EXPECT_EQ(Largest(*fragments, round), 0);
}

TEST(RegionSource, AsksThePictureForTheRegionsCells) {
  class Picture : public FragmentSource {
   public:
    Result<Fragments> Query(const SamplePlan& plan) override {
      EXPECT_EQ(plan.grid, kGrid);
      return Slope()(plan, 0);
    }
  } picture;
  // Columns 2 and 3 of rows 1 and 3.
  const Region region{kGrid, 2, 2, 1, 2};
  EXPECT_EQ(region.size(), (GridSize{2, 2}));
  const auto fragments =
      RegionSource(picture, region).Query(RegularPlan({2, 2}, 1, 1));
  ASSERT_TRUE(fragments.has_value());
  EXPECT_EQ(fragments->grid, (GridSize{2, 2}));
  EXPECT_EQ(fragments->values[0], Rgb(2.5f, 1.5f, 0));
  EXPECT_EQ(fragments->values[1], Rgb(3.5f, 1.5f, 0));
  EXPECT_EQ(fragments->values[2], Rgb(2.5f, 3.5f, 0));
}

}  // namespace
}  // namespace rtb
