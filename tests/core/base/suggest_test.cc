#include "core/base/suggest.h"

#include <gtest/gtest.h>

#include <vector>

namespace rtb {
namespace {

const std::vector<std::string> kNames = {"half", "quadrant", "tiv"};

TEST(DidYouMeanTest, FindsTheNearestName) {
  EXPECT_EQ(DidYouMean("quadrnat", kNames), "did you mean `quadrant`?");
  EXPECT_EQ(DidYouMean("hlaf", kNames), "did you mean `half`?");
  EXPECT_EQ(DidYouMean("hlf", kNames), "did you mean `half`?");
  EXPECT_EQ(DidYouMean("tiv2", kNames), "did you mean `tiv`?");
}

// 4 letters allow max(1, 4 / 3) = 1 edit: `tiv` is 2 away from `this`.
TEST(DidYouMeanTest, IsSilentWhenNothingIsNear) {
  EXPECT_EQ(DidYouMean("sphere", kNames), "");
  EXPECT_EQ(DidYouMean("this", kNames), "");
  EXPECT_EQ(DidYouMean("", kNames), "");
  EXPECT_EQ(DidYouMean("half", {}), "");
  EXPECT_EQ(DidYouMean(std::string(100000, 'x'), kNames), "");
}

TEST(JoinNamesTest, SeparatesByCommas) {
  EXPECT_EQ(JoinNames(kNames), "half, quadrant, tiv");
  EXPECT_EQ(JoinNames({}), "");
}

}  // namespace
}  // namespace rtb
