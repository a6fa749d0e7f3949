#include "harness/arguments.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rtb {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

TEST(ParseGrid, TakesColumnsByRows) {
  EXPECT_EQ(ParseGrid("--grid", "120x40").value(), (GridSize{120, 40}));
  EXPECT_EQ(ParseGrid("--grid", "1x4096").value(), (GridSize{1, 4096}));
}

class BadGrid : public ::testing::TestWithParam<const char*> {};

TEST_P(BadGrid, SaysWhatWasFoundAndExpected) {
  const auto grid = ParseGrid("--grid", GetParam());
  ASSERT_FALSE(grid.has_value());
  EXPECT_EQ(grid.error().kind, ErrorKind::kBadInput);
  EXPECT_EQ(grid.error().place, "--grid");
  EXPECT_THAT(grid.error().what,
              AllOf(HasSubstr("'" + std::string(GetParam()) + "'"),
                    HasSubstr("COLSxROWS such as 120x40")));
}

INSTANTIATE_TEST_SUITE_P(Texts, BadGrid,
                         ::testing::Values("", "120", "axb", "x", "120x", "x40",
                                           "0x40", "120x0", "-1x40", "120x-40",
                                           "+120x40", "120x40x2", "120X40",
                                           " 120x40", "120x40 ", "4097x1",
                                           "1x4097", "99999999999999999999x1",
                                           "1.5x2", "1e3x2"));

TEST(ParseImageSize, BoundsTheProduct) {
  EXPECT_TRUE(ParseImageSize("--size", "16384x16384").has_value());  // 2^28
  EXPECT_FALSE(ParseImageSize("--size", "16384x16385").has_value());
  EXPECT_FALSE(ParseImageSize("--size", "65537x1").has_value());
}

TEST(ParseInteger, TakesTheWholeTextWithinItsBounds) {
  EXPECT_EQ(ParseInteger("--spp", "7", 1, 8).value(), 7);
  for (const char* text :
       {"0", "9", "-1", "7 ", "7.0", "", "seven", "18446744073709551617"}) {
    const auto number = ParseInteger("--spp", text, 1, 8);
    ASSERT_FALSE(number.has_value()) << text;
    EXPECT_THAT(number.error().what, HasSubstr("from 1 to 8"));
  }
}

TEST(ParseSeed, CoversAll64Bits) {
  EXPECT_EQ(ParseSeed("--seed", "18446744073709551615").value(), UINT64_MAX);
  EXPECT_FALSE(ParseSeed("--seed", "18446744073709551616").has_value());
  EXPECT_FALSE(ParseSeed("--seed", "-1").has_value());
}

TEST(ParseNumber, IsFinite) {
  EXPECT_EQ(ParseNumber("--exposure", "-1.5", -64, 64).value(), -1.5);
  for (const char* text : {"nan", "inf", "-inf", "65", "1,5", "1.5x", ""}) {
    EXPECT_FALSE(ParseNumber("--exposure", text, -64, 64).has_value()) << text;
  }
}

TEST(CheckSampleCount, StopsAtTheLimit) {
  // 4096 x 4096 cells x 16 samples = 2^28, the limit itself.
  EXPECT_TRUE(
      CheckSampleCount("--grid", RegularPlan({4096, 4096}, 4, 4)).has_value());
  EXPECT_FALSE(
      CheckSampleCount("--grid", RegularPlan({4096, 4096}, 17, 1)).has_value());
}

TEST(RasterSize, MultipliesWithinTheLimit) {
  EXPECT_EQ(RasterSize({120, 40}, {8, 16}).value(), (PixelSize{960, 640}));
  // 1024 * 8 x 512 * 16 = 8192 x 8192 = 2^26, the limit itself.
  EXPECT_TRUE(RasterSize({1024, 512}, {8, 16}).has_value());
  EXPECT_FALSE(RasterSize({1024, 513}, {8, 16}).has_value());
  EXPECT_FALSE(RasterSize({4096, 4096}, {256, 256}).has_value());
}

}  // namespace
}  // namespace rtb
