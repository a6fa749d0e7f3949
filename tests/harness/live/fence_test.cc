#include "harness/live/fence.h"

#include <gtest/gtest.h>

#include <cmath>

namespace rtb {
namespace {

TEST(Fence, LetsTwoFramesWait) {
  Fence fence(true);
  EXPECT_TRUE(fence.Open(0));
  fence.Sent(0, 100);
  EXPECT_TRUE(fence.Open(0.01));
  fence.Sent(0.01, 100);
  EXPECT_FALSE(fence.Open(0.02));
  fence.Answered(0.03);
  EXPECT_TRUE(fence.Open(0.03));
  EXPECT_NEAR(fence.latency_ms(), 30, 1e-9);
}

TEST(Fence, NeverHangsOnATerminalThatIsSilent) {
  Fence fence(true);
  double now = 0;
  // Three times half a second in vain, then it is off.
  for (int i = 0; i < 3; ++i) {
    fence.Sent(now, 1);
    fence.Sent(now, 1);
    EXPECT_FALSE(fence.Open(now));
    EXPECT_NEAR(fence.Deadline(), now + Fence::kTimeout, 1e-9);
    now += Fence::kTimeout + 0.01;
    EXPECT_TRUE(fence.Open(now));
  }
  EXPECT_FALSE(fence.on());
  for (int i = 0; i < 10; ++i) fence.Sent(now, 1);
  EXPECT_TRUE(fence.Open(now));
  EXPECT_TRUE(std::isinf(fence.Deadline()));
}

TEST(Fence, MeasuresHowManyCellsATerminalDraws) {
  Fence fence(true);
  EXPECT_EQ(fence.cells_per_second(), 0);
  fence.Sent(0, 1000);
  fence.Sent(0, 1000);
  fence.Answered(0.01);
  fence.Answered(0.02);  // The second frame began when the first was done.
  EXPECT_NEAR(fence.cells_per_second(), 1e5, 1);
}

TEST(Fence, IgnoresAnswersToNothing) {
  Fence fence(true);
  fence.Answered(1);
  EXPECT_FALSE(fence.waiting());
  EXPECT_TRUE(fence.Open(1));
}

}  // namespace
}  // namespace rtb
