#include "harness/live/frame_times.h"

#include <gtest/gtest.h>

namespace rtb {
namespace {

TEST(Percentile, IsTheNearestRank) {
  EXPECT_EQ(Percentile({}, 0.5), 0);
  EXPECT_EQ(Percentile({7}, 0.99), 7);
  // Of 1..10 half do not exceed 5, 95 % need the tenth.
  EXPECT_EQ(Percentile({10, 9, 8, 7, 6, 5, 4, 3, 2, 1}, 0.5), 5);
  EXPECT_EQ(Percentile({10, 9, 8, 7, 6, 5, 4, 3, 2, 1}, 0.95), 10);
}

TEST(FrameTimes, RateAndIntervals) {
  FrameTimes times(100);
  for (int i = 0; i <= 50; ++i) times.Add(i * 0.02);
  EXPECT_NEAR(times.Rate(), 50, 1e-6);
  EXPECT_EQ(times.Intervals().size(), 50u);
  EXPECT_NEAR(times.Intervals().front(), 20, 1e-9);
}

TEST(FrameTimes, PausesDoNotCount) {
  FrameTimes times(100);
  times.Add(0);
  times.Add(0.01);
  times.Pause();
  times.Add(100);
  times.Add(100.01);
  for (const double interval : times.Intervals()) EXPECT_LT(interval, 11);
  EXPECT_EQ(times.Intervals().size(), 2u);
}

TEST(FrameTimes, RemembersNoMoreThanItsLimit) {
  FrameTimes times(3);
  for (int i = 0; i < 10; ++i) times.Add(i);
  EXPECT_EQ(times.Intervals().size(), 3u);
}

TEST(FrameTimes, DrawsItsGraph) {
  FrameTimes times(10);
  times.Add(0);
  times.Add(0.010);  // 10 of 40 ms: two eighths.
  times.Add(0.030);  // 20: four.
  times.Add(0.130);  // 100: all.
  EXPECT_EQ(times.Graph(5, 40), U"  ▂▄█");
}

}  // namespace
}  // namespace rtb
