#include "core/shading/material.h"

#include <gtest/gtest.h>

namespace rtb {
namespace {

const CheckerData kChecker{Rgb(1), Rgb(0), 1};

TEST(CheckerColorTest, ParityOfTheFloors) {
  const V3f up(0, 1, 0);
  EXPECT_EQ(CheckerColor(kChecker, V3f(0.5f, 0, 0.5f), up), Rgb(1));
  EXPECT_EQ(CheckerColor(kChecker, V3f(1.5f, 0, 0.5f), up), Rgb(0));
  EXPECT_EQ(CheckerColor(kChecker, V3f(1.5f, 0, 1.5f), up), Rgb(1));
  EXPECT_EQ(CheckerColor(kChecker, V3f(-0.5f, 0, 0.5f), up), Rgb(0));
  EXPECT_EQ(CheckerColor(kChecker, V3f(-0.5f, 0, -0.5f), up), Rgb(1));
}

TEST(CheckerColorTest, TheNormalDecidesOnACellBorder) {
  // y = 0 moved up is in cell 0, moved down in cell -1.
  EXPECT_EQ(CheckerColor(kChecker, V3f(0.5f, 0, 0.5f), V3f(0, 1, 0)), Rgb(1));
  EXPECT_EQ(CheckerColor(kChecker, V3f(0.5f, 0, 0.5f), V3f(0, -1, 0)), Rgb(0));
  // Rounding below the border by less than size/1000 changes nothing.
  EXPECT_EQ(CheckerColor(kChecker, V3f(0.5f, -1e-5f, 0.5f), V3f(0, 1, 0)),
            Rgb(1));
}

TEST(CheckerColorTest, SizeScalesCellsAndOffset) {
  const CheckerData big{Rgb(1), Rgb(0), 100};
  EXPECT_EQ(CheckerColor(big, V3f(99, -0.05f, 1), V3f(0, 1, 0)), Rgb(1));
  EXPECT_EQ(CheckerColor(big, V3f(101, 0, 1), V3f(0, 1, 0)), Rgb(0));
}

TEST(CheckerColorTest, FarOutStaysOneOfTheTwo) {
  const Rgb c = CheckerColor(kChecker, V3f(1e30f, 0, -3e25f), V3f(0, 1, 0));
  EXPECT_TRUE(c == Rgb(0) || c == Rgb(1));
}

}  // namespace
}  // namespace rtb
