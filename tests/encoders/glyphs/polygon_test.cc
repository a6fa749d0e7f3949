#include "encoders/glyphs/polygon.h"

#include <gtest/gtest.h>

#include "encoders/glyphs/shape.h"

namespace rtb {
namespace {

// The half of a cell below its falling diagonal: of 2 x 2 sub-pixels two are
// halved, one is whole and one is free, exactly.
TEST(PolygonTest, CoversExactShares) {
  const ShapePolygon half = {
      {0, 0}, {0, kShapeUnits}, {kShapeUnits, kShapeUnits}};
  EXPECT_EQ(CoveredShare(half, 0, 0, 2, 2), 0.5);
  EXPECT_EQ(CoveredShare(half, 1, 0, 2, 2), 0);
  EXPECT_EQ(CoveredShare(half, 0, 1, 2, 2), 1);
  EXPECT_EQ(CoveredShare(half, 1, 1, 2, 2), 0.5);
  EXPECT_EQ(CoveredShare(half, 0, 0, 1, 1), 0.5);
}

TEST(PolygonTest, DoesNotDependOnTheDirection) {
  const ShapePolygon forth = {{7, 3}, {60, 20}, {30, 70}};
  const ShapePolygon back(forth.rbegin(), forth.rend());
  for (int x = 0; x < 5; ++x) {
    EXPECT_NEAR(CoveredShare(forth, x, 1, 5, 3), CoveredShare(back, x, 1, 5, 3),
                1e-15);
  }
}

// A notch that reaches down to the middle of the cell leaves two parts of the
// upper half: in a row of one sub-pixel they are clipped apart. The notch is a
// triangle of width 1 and height 1/2, a quarter; the upper half loses half of
// its area.
TEST(PolygonTest, SurvivesFallingApart) {
  const ShapePolygon notched = {{0, 0},
                                {36, 36},
                                {kShapeUnits, 0},
                                {kShapeUnits, kShapeUnits},
                                {0, kShapeUnits}};
  EXPECT_DOUBLE_EQ(CoveredShare(notched, 0, 0, 1, 2), 0.5);
  EXPECT_DOUBLE_EQ(CoveredShare(notched, 0, 1, 1, 2), 1);
  // The uppermost quarter loses 3/4.
  EXPECT_DOUBLE_EQ(CoveredShare(notched, 0, 0, 1, 4), 0.25);
}

}  // namespace
}  // namespace rtb
