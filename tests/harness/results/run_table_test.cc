#include "harness/results/run_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/harness/results/sample_record.h"

namespace rtb {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

// render: median 4, its interval the range of three values; CV 2 / 4 = 50 %.
TEST(RunTableTest, ShowsEncodersSideBySide) {
  EXPECT_THAT(
      FormatRunTable(SampleRecord().runs),
      StartsWith(
          "cornell, 120x40 cells; compared at 960x640 pixels, FLIP at 40 "
          "pixels "
          "per degree\n"
          "encoder                rays/cell         render ms         encode ms"
          "  frames/s       MSE  PSNR dB    SSIM  FLIP@40PPD\n"
          "---------------------  ---------  ----------------  ----------------"
          "  --------  --------  -------  ------  ----------\n"
          "quadrant:blend=linear          4  4.00 [2.00-6.00]  1.00 [1.00-1.00]"
          "     200.0  0.001637    27.86  0.5000      0.1000\n"
          "adaptive                    2.50                 -                 -"
          "         -         -        -       -      0.0000\n"
          "warning: quadrant:blend=linear: the times of 'render' vary by 50 % "
          "(coefficient of variation): do not compare them; run more often, or "
          "on "
          "a quieter machine\n\nencoder "));
}

TEST(RunTableTest, SteadyTimesGiveNoWarning) {
  RunResult run = SampleRecord().runs[0];
  run.times[0].samples = {10, 11, 10};
  run.times.push_back({"plan", {1, 2, 3}, {}});  // not shown
  EXPECT_THAT(FormatRunTable(std::span(&run, 1)), Not(HasSubstr("warning")));
}

TEST(RunTableTest, GivesEachSceneAndGridATable) {
  std::vector<RunResult> runs = SampleRecord().runs;
  runs.insert(runs.begin() + 1, runs[0]);
  runs[1].scene = "rayterm";
  runs[1].grid = {80, 30};
  const std::string text = FormatRunTable(runs);
  EXPECT_THAT(text, HasSubstr("\n\nrayterm, 80x30 cells; compared at"));
  EXPECT_EQ(text.find("cornell,"), text.rfind("cornell,"));
}

TEST(RunTableTest, OfNothingIsEmpty) { EXPECT_EQ(FormatRunTable({}), ""); }

}  // namespace
}  // namespace rtb
