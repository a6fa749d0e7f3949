#include "harness/commands/progress.h"

#include <gtest/gtest.h>

namespace rtb {
namespace {

TEST(ProgressTest, DurationsRoundUp) {
  EXPECT_EQ(DurationText(-1), "0 s");
  EXPECT_EQ(DurationText(0.2), "1 s");
  EXPECT_EQ(DurationText(59), "59 s");
  EXPECT_EQ(DurationText(59.5), "1 min");
  EXPECT_EQ(DurationText(61), "2 min");
  EXPECT_EQ(DurationText(3600), "1 h 00 min");
  EXPECT_EQ(DurationText(3600 * 2 + 4 * 60 + 1), "2 h 05 min");
}

TEST(ProgressTest, ABarFillsFromTheLeft) {
  EXPECT_EQ(BarText(0, 4), "[----]");
  EXPECT_EQ(BarText(0.5, 4), "[##--]");
  EXPECT_EQ(BarText(0.99, 4), "[###-]");
  EXPECT_EQ(BarText(1, 4), "[####]");
}

}  // namespace
}  // namespace rtb
