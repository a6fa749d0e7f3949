#include "harness/sweep/expand.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/harness/sweep/suites.h"

namespace rtb {
namespace {

using ::testing::ElementsAre;

std::vector<std::string> Lines(const std::vector<SweepUnit>& units) {
  std::vector<std::string> lines;
  for (const SweepUnit& unit : units) lines.push_back(Describe(unit));
  return lines;
}

std::vector<std::string> Expanded(const std::string& rest) {
  const SuiteFolder suites;
  return Lines(Expand(suites.Parse(rest).value()));
}

TEST(ExpandTest, ScenesStandTogetherAndTimedUnitsLast) {
  EXPECT_THAT(
      Expanded("scenes: [sky, sun]\nencoders: [half, tiv]\n"
               "grids: [12x4]\n"
               "matrix: [{}, {scenes: [sky], colors: [16]}]\n"
               "live: {scenes: [sky], encoders: [half], grid: 12x4}\n"),
      ElementsAre("quality sky 12x4 half", "quality sky 12x4 tiv",
                  "quality sky 12x4 color=16 half",
                  "quality sky 12x4 color=16 tiv", "quality sun 12x4 half",
                  "quality sun 12x4 tiv", "timing sky 12x4 2 encoders",
                  "timing sky 12x4 color=16 2 encoders",
                  "timing sun 12x4 2 encoders", "live sky 12x4 half"));
}

// 2 scenes x 2 times x 2 grids x 2 spp x 2 integrators x 2 colors x
// 2 references x 3 encoders = 384 quality units, and without references and
// encoders 64 blocks; at spp 2 or by `path` (3 of 4 pairs) 2 seeds: 384 / 4
// * 7.
TEST(ExpandTest, IsTheProductOfAllLists) {
  const SuiteFolder suites;
  const auto units = Expand(
      suites
          .Parse("scenes: [sky, sun]\ntimes: [0, 1]\ngrids: [12x4, 24x8]\n"
                 "spp: [1, 2]\nintegrators: [whitted, path]\n"
                 "colors: [truecolor, mono]\nreferences: [auto, self]\n"
                 "encoders: [half, quadrant, tiv]\nseeds: [1, 2]\n")
          .value());
  const auto timed = std::ranges::count_if(
      units, [](const SweepUnit& unit) { return IsTimed(unit.kind); });
  EXPECT_EQ(timed, 64);
  EXPECT_EQ(static_cast<long>(units.size()) - timed, 384 / 4 * 7);
  std::set<std::string> keys;
  for (const SweepUnit& unit : units) {
    keys.insert(ConfigurationKey(unit.kind, unit.configuration));
  }
  EXPECT_EQ(keys.size(), units.size());
}

TEST(ExpandTest, SeedsAreUsedWhereSomethingIsRandom) {
  EXPECT_THAT(Expanded("scenes: [sky]\ngrids: [12x4]\nkinds: [quality]\n"
                       "seeds: [4, 5]\n"
                       "encoders: [half, search, 'search:seed=9', adaptive]\n"),
              ElementsAre("quality sky 12x4 seed=4 half",
                          "quality sky 12x4 seed=4 search",
                          "quality sky 12x4 seed=5 search",
                          "quality sky 12x4 seed=4 search:seed=9",
                          "quality sky 12x4 seed=4 adaptive",
                          "quality sky 12x4 seed=5 adaptive"));
}

TEST(ExpandTest, PicturesAreKeptOfTheFirstSeed) {
  const SuiteFolder suites;
  const auto units =
      Expand(suites
                 .Parse("scenes: [sky]\nkinds: [quality]\nseeds: [4, 5]\n"
                        "encoders: [search]\n")
                 .value());
  ASSERT_EQ(units.size(), 2u);
  EXPECT_TRUE(units[0].pictures);
  EXPECT_FALSE(units[1].pictures);
}

TEST(ExpandTest, RulesLeaveOutWhatTheyName) {
  EXPECT_THAT(
      Expanded("scenes: [sky, sun]\ngrids: [12x4, 24x8]\ntimes: [0, 2.5]\n"
               "encoders: [half, 'search:rays=12', 'search:rays=8']\n"
               "exclude:\n"
               "  - {time: 2.50}\n"
               "  - {scene: sun, grid: [24x8, 48x16]}\n"
               "  - {kind: timing, encoder: search}\n"
               "  - {scene: sky, encoder: 'search:rays=8'}\n"
               "  - {kind: quality, grid: 24x8}\n"),
      ElementsAre("quality sky 12x4 half", "quality sky 12x4 search:rays=12",
                  "quality sun 12x4 half", "quality sun 12x4 search:rays=12",
                  "quality sun 12x4 search:rays=8", "timing sky 12x4 half",
                  "timing sky 24x8 half", "timing sun 12x4 half"));
}

TEST(ExpandTest, WorkNamedTwiceIsDoneOnce) {
  EXPECT_THAT(Expanded("scenes: [sky]\ngrids: [12x4]\nkinds: [quality]\n"
                       "encoders: [half, half]\nmatrix: [{}, {}]\n"),
              ElementsAre("quality sky 12x4 half"));
}

TEST(ExpandTest, MovingScenesGiveOneUnitAnEncoder) {
  EXPECT_THAT(Expanded("temporal: {scenes: [sky], encoders: [half, "
                       "'half:temporal=3'], grid: 12x4}\n"),
              ElementsAre("temporal sky 12x4 half",
                          "temporal sky 12x4 half:temporal=3"));
}

TEST(ExpandTest, TemporalUnitsTakeTheirRaysAndFrames) {
  const SuiteFolder suites;
  const auto units =
      Expand(suites
                 .Parse("temporal: {scenes: [sky], encoders: [half], spp: 4, "
                        "frames: 30, fps: 12}\n")
                 .value());
  ASSERT_EQ(units.size(), 1U);
  EXPECT_EQ(units.front().configuration.spp, 4);
  EXPECT_EQ(units.front().frames, 30);
  EXPECT_EQ(units.front().fps, 12);
}

}  // namespace
}  // namespace rtb
