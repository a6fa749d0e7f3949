#include "harness/results/cost_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/harness/results/sample_record.h"

namespace rtb {
namespace {

using testing::DoubleEq;
using testing::Optional;

/// 21600 rays (12000 + 300 + 200 + 100 + 9000) in a median of 4 ms.
RunResult TimedRun() {
  const RunRecord record = SampleRecord();
  RunResult run = record.runs[1];
  run.times = record.runs[0].times;
  return run;
}

TEST(CostTableTest, RaysPerSecondTakeTheMedian) {
  EXPECT_THAT(RaysPerSecond(TimedRun()), Optional(DoubleEq(5.4e6)));
  EXPECT_EQ(RaysPerSecond(SampleRecord().runs[0]), std::nullopt);  // no rays
  EXPECT_EQ(RaysPerSecond(SampleRecord().runs[1]), std::nullopt);  // no times
}

TEST(CostTableTest, ShowsRaysByKind) {
  RunResult run = TimedRun();
  run.times.push_back({"load", {2}, {}});
  run.times.push_back({"build", {0.5}, {}});
  const RunResult* const runs[] = {&run};
  EXPECT_EQ(FormatCostTable(runs),
            "encoder   camera rays  reflected  refracted  scattered  shadow"
            "  Mrays/s  bytes/frame\n"
            "--------  -----------  ---------  ---------  ---------  ------"
            "  -------  -----------\n"
            "adaptive        12000        300        200        100    9000"
            "     5.40       123456\n"
            "loading the scene takes 2.00 ms, building its accelerator 0.50 "
            "ms\n");
}

TEST(CostTableTest, IsEmptyWhereNothingIsKnown) {
  const RunResult run = SampleRecord().runs[0];
  const RunResult* const runs[] = {&run};
  EXPECT_EQ(FormatCostTable(runs), "");
}

}  // namespace
}  // namespace rtb
