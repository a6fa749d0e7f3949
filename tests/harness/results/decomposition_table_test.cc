#include "harness/results/decomposition_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "tests/harness/results/sample_record.h"

namespace rtb {
namespace {

using testing::EndsWith;

// Of an MSE of 8: 1, 2 and 4 by step, 1 in common, 2 by the font; of the
// encoding's 4 the glyphs 2, masks 1.5, colors 0.5.
TEST(DecompositionTableTest, ShowsShares) {
  RunResult run = SampleRecord().runs[1];
  run.decomposition = Decomposition{{1, 2, 4, 0.5, 0.25, 0.25, 8, 2},
                                    {0.1, 0.2, 0.3, 0.4, 0.25},
                                    InnerTerms{2, 1.5, 0.5}};
  run.bound->gap = 1.5;
  const RunResult* const runs[] = {&run};
  const std::string text = FormatDecompositionTable(runs);
  const std::string row = text.substr(text.find("adaptive"));
  std::istringstream words(row);
  std::vector<std::string> values;
  for (std::string word; words >> word;) values.push_back(word);
  EXPECT_THAT(values,
              testing::ElementsAre("adaptive", "8.000000", "12.5", "25.0",
                                   "50.0", "12.5", "25.0", "50.0", "37.5",
                                   "12.5", "0.2500", "1.500"));
}

TEST(DecompositionTableTest, WhatIsUndefinedIsADash) {
  RunResult run = SampleRecord().runs[1];
  run.decomposition->inner.reset();
  run.bound.reset();
  const RunResult* const runs[] = {&run};
  EXPECT_THAT(FormatDecompositionTable(runs), EndsWith("-\n"));
}

TEST(DecompositionTableTest, IsEmptyWhereNothingWasDecomposed) {
  const RunResult run = SampleRecord().runs[0];
  const RunResult* const runs[] = {&run};
  EXPECT_EQ(FormatDecompositionTable(runs), "");
}

}  // namespace
}  // namespace rtb
