// What `adaptive` shows at the edge of a lamp, which is brighter than white.
#include <gtest/gtest.h>

#include "encoders/adaptive/rebuild.h"

namespace rtb {
namespace {

/// The sum of the red of a cell whose upper half is of that light and whose
/// lower half is black, seen by 32 samples a cell.
float SumOf(const Rgb& light) {
  SamplePlan plan;
  plan.grid = {3, 3};
  for (int i = 0; i < 32; ++i) {
    plan.positions.emplace_back((static_cast<float>(i % 4) + 0.5f) / 4,
                                (static_cast<float>(i / 4) + 0.5f) / 8);
  }
  plan.samples_per_cell = 32;
  Fragments fragments;
  for (int cell = 0; cell < 9; ++cell) {
    for (const V2f& at : plan.positions) {
      const float down = static_cast<float>(cell / 3) + at.y;
      fragments.values.push_back(down < 1.5f ? light : Rgb(0));
    }
  }
  SeenSamples samples(plan.grid);
  samples.Add(plan, fragments);
  const RebuiltRaster raster = Rebuild(samples, 8, 16, 0.5, Texture::kKept, 1);
  float sum = 0;
  for (const Rgb& color : raster.cell(4)) sum += color.x;
  return sum;
}

// Beside a lamp of all colors the plain distances count, by which three samples
// in the triangles of the pattern are mixed; beside one that is not white the
// edge stretches them, and the dark side stays as dark as it is seen.
TEST(RebuildLampTest, MixesBothSidesAtALampAlone) {
  const float lamp = SumOf(Rgb(15));
  const float red = SumOf(Rgb(15, 0.9f, 0.9f));
  EXPECT_GT(lamp, red * 1.005f);
}

// A pixel's light is its mean before it is clipped: where both sides are mixed
// there is more of a brighter lamp, up to a bound.
TEST(RebuildLampTest, ShowsMoreOfABrighterLamp) {
  EXPECT_GT(SumOf(Rgb(2)), SumOf(Rgb(1)) * 1.005f);
  EXPECT_GT(SumOf(Rgb(kBrightest)), SumOf(Rgb(2)) * 1.005f);
  EXPECT_EQ(SumOf(Rgb(15)), SumOf(Rgb(kBrightest)));
}

}  // namespace
}  // namespace rtb
