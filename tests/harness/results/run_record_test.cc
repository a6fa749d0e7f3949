#include "harness/results/run_record.h"

#include <gtest/gtest.h>

#include "tests/harness/results/sample_record.h"

namespace rtb {
namespace {

TEST(RunResultTest, FindsStagesAndMetrics) {
  const RunResult run = SampleRecord().runs[0];
  ASSERT_NE(FindStage(run, "encode"), nullptr);
  EXPECT_EQ(FindStage(run, "encode")->samples, std::vector<double>{1});
  EXPECT_EQ(FindStage(run, "emit"), nullptr);
  EXPECT_EQ(FindMetricValue(run, "psnr"), 27.86);
  EXPECT_EQ(FindMetricValue(run, "nonsense"), std::nullopt);
}

// Medians of 4 ms for rendering and 1 ms for encoding: 200 frames a second;
// with 5 ms for planning 100.
TEST(RunResultTest, FramesPerSecondAddsAllStages) {
  RunResult run = SampleRecord().runs[0];
  EXPECT_DOUBLE_EQ(FramesPerSecond(run).value_or(0), 200);
  run.times.push_back({"plan", {5}, {}});
  EXPECT_DOUBLE_EQ(FramesPerSecond(run).value_or(0), 100);
  run.times.erase(run.times.begin());
  EXPECT_FALSE(FramesPerSecond(run).has_value());
}

TEST(RunResultTest, NoTimeGivesNoFramesPerSecond) {
  RunResult run;
  run.times = {{"render", {0}, {}}, {"encode", {0}, {}}};
  EXPECT_FALSE(FramesPerSecond(run).has_value());
}

}  // namespace
}  // namespace rtb
