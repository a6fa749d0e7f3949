#include "encoders/modifiers/raster.h"

#include <gtest/gtest.h>

namespace rtb {
namespace {

/// One cell with a white sample near its upper left corner and a black one
/// near its lower right corner.
Evidence TwoSamples() {
  SampleRound round;
  round.plan.grid = {1, 1};
  round.plan.samples_per_cell = 2;
  round.plan.positions = {V2f(0.25f, 0.25f), V2f(0.75f, 0.75f)};
  round.plan.footprint = V2f(0.125f, 0.125f);
  round.fragments = Fragments(round.plan);
  round.fragments.values = {Rgb(1), Rgb(0)};
  Evidence evidence;
  evidence.rounds.push_back(std::move(round));
  return evidence;
}

// In a cell twice as high as wide the two are equally far where dx + 4 dy = 0
// around its middle: the upper 2 x 2 sub-pixels are nearer to the first.
TEST(NearestRasterTest, ShowsTheNearestSample) {
  const SampleRaster raster =
      NearestRaster(TwoSamples(), 2, 4, Blend::kLinear, 1);
  ASSERT_EQ(raster.values.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(raster.values[i], V3d(i < 4 ? 1 : 0)) << i;
  }
}

// Where the samples form a raster, RasterOf keeps it and NearestRaster can
// still be asked for any other.
TEST(NearestRasterTest, TakesAnySizeOfARegularRaster) {
  SampleRound round;
  round.plan = RegularPlan({1, 1}, 1, 2);
  round.fragments = Fragments(round.plan);
  round.fragments.values = {Rgb(1), Rgb(0)};
  Evidence evidence;
  evidence.rounds.push_back(std::move(round));
  EXPECT_EQ(RasterOf(evidence, Blend::kLinear, 1).values.size(), 2u);
  const SampleRaster raster = NearestRaster(evidence, 8, 16, Blend::kLinear, 1);
  EXPECT_EQ(raster.width, 8);
  for (std::size_t i = 0; i < 128; ++i) {
    EXPECT_EQ(raster.values[i], V3d(i < 64 ? 1 : 0)) << i;
  }
}

}  // namespace
}  // namespace rtb
