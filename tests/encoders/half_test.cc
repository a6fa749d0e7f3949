#include <gtest/gtest.h>

#include "tests/encoders/picture_source.h"
#include "tests/encoders/testing.h"

namespace rtb {
namespace {

TEST(HalfTest, UpperSampleIsTheBackground) {
  EXPECT_EQ(EncodeOne("half", {{10, 20, 30}, {200, 100, 0}}),
            (Cell{U'▄', {200, 100, 0}, {10, 20, 30}}));
}

TEST(HalfTest, EncodesEveryCellInPlace) {
  const CellGrid grid = EncodeValues(
      "half", {2, 2}, GrayValues({{0, 1}, {2, 3}, {4, 5}, {6, 255}}));
  EXPECT_EQ(GlyphText(grid), "▄▄\n▄▄\n");
  EXPECT_EQ(grid.at(1, 0), (Cell{U'▄', {3, 3, 3}, {2, 2, 2}}));
  EXPECT_EQ(grid.at(0, 1), (Cell{U'▄', {5, 5, 5}, {4, 4, 4}}));
  EXPECT_EQ(grid.at(1, 1), (Cell{U'▄', {255, 255, 255}, {6, 6, 6}}));
}

TEST(HalfTest, SamplesTheMiddleOfEachHalf) {
  PictureSource source([](double x, double y, int) { return x + y; });
  ASSERT_TRUE(Make("half")->Run(source, {1, 1}, 0.5, {}));
  ASSERT_EQ(source.plans().size(), 1u);
  EXPECT_EQ(source.plans()[0].positions,
            (std::vector<V2f>{V2f(0.5f, 0.25f), V2f(0.5f, 0.75f)}));
}

}  // namespace
}  // namespace rtb
