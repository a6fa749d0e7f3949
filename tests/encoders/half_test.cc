#include <gtest/gtest.h>

#include "tests/encoders/testing.h"

namespace rtb {
namespace {

TEST(HalfTest, UpperSampleIsTheBackground) {
  EXPECT_EQ(EncodeOne("half", {{10, 20, 30}, {200, 100, 0}}),
            (Cell{U'▄', {200, 100, 0}, {10, 20, 30}}));
}

TEST(HalfTest, EncodesEveryCellInPlace) {
  const auto encoder = Make("half");
  const SamplePlan plan = encoder->Plan({2, 2}, 0.5, 0);
  const CellGrid grid = encoder->Encode(
      GrayFragments(plan, {{0, 1}, {2, 3}, {4, 5}, {6, 255}}), {});
  EXPECT_EQ(GlyphText(grid), "▄▄\n▄▄\n");
  EXPECT_EQ(grid.at(1, 0), (Cell{U'▄', {3, 3, 3}, {2, 2, 2}}));
  EXPECT_EQ(grid.at(0, 1), (Cell{U'▄', {5, 5, 5}, {4, 4, 4}}));
  EXPECT_EQ(grid.at(1, 1), (Cell{U'▄', {255, 255, 255}, {6, 6, 6}}));
}

TEST(HalfTest, SamplesTheMiddleOfEachHalf) {
  const SamplePlan plan = Make("half")->Plan({1, 1}, 0.5, 0);
  EXPECT_EQ(plan.positions,
            (std::vector<V2f>{V2f(0.5f, 0.25f), V2f(0.5f, 0.75f)}));
}

}  // namespace
}  // namespace rtb
