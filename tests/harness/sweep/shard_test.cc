#include "harness/sweep/shard.h"

#include <gtest/gtest.h>

#include <map>

#include "harness/sweep/expand.h"
#include "tests/harness/sweep/suites.h"

namespace rtb {
namespace {

std::vector<SweepUnit> Units() {
  const SuiteFolder suites;
  return Expand(suites
                    .Parse("scenes: [sky, sun]\ngrids: [12x4, 24x8, 48x16]\n"
                           "encoders: [half, search]\nseeds: [1, 2]\n")
                    .value());
}

TEST(ShardTest, EveryUnitIsInExactlyOneSlice) {
  const std::vector<SweepUnit> units = Units();
  for (const int count : {1, 2, 3, 5, 100}) {
    std::map<std::string, int> seen;
    for (int i = 0; i < count; ++i) {
      for (const SweepUnit& unit : SliceOf(units, {i, count})) {
        ++seen[ConfigurationKey(unit.kind, unit.configuration)];
      }
    }
    EXPECT_EQ(seen.size(), units.size()) << count;
    for (const auto& [key, times] : seen) EXPECT_EQ(times, 1) << key;
  }
}

// 2 scenes x 3 grids: 6 blocks of quality, of 3 units each, and 6 of timing;
// each of two slices gets half of both.
TEST(ShardTest, BlocksStayWholeAndAreDealtOutEvenly) {
  const std::vector<SweepUnit> units = Units();
  ASSERT_EQ(units.size(), 6u * 3 + 6);
  for (int i = 0; i < 2; ++i) {
    std::map<std::string, int> blocks;
    for (const SweepUnit& unit : SliceOf(units, {i, 2})) {
      const UnitConfiguration& c = unit.configuration;
      ++blocks[NameOf(unit.kind) + c.scene + std::to_string(c.grid.columns)];
    }
    EXPECT_EQ(blocks.size(), 6u);
    int quality = 0;
    for (const auto& [name, size] : blocks) {
      const bool timing = name.starts_with("timing");
      EXPECT_EQ(size, timing ? 1 : 3) << name;
      quality += timing ? 0 : 1;
    }
    EXPECT_EQ(quality, 3);
  }
}

TEST(ShardTest, ParsesSlices) {
  EXPECT_EQ(ParseShard("--shard", "0/1")->count, 1);
  EXPECT_EQ(ParseShard("--shard", "2/3")->index, 2);
  for (const char* wrong :
       {"", "1", "/", "3/3", "-1/3", "1/0", "0x1/2", "1/2 ", "1/9999999"}) {
    EXPECT_FALSE(ParseShard("--shard", wrong)) << wrong;
  }
}

}  // namespace
}  // namespace rtb
