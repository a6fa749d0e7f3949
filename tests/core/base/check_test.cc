#include "core/base/check.h"

#include <gtest/gtest.h>

namespace rtb {
namespace {

TEST(CheckDeathTest, NamesTheConditionAndThePlace) {
  EXPECT_DEATH(RTB_CHECK(1 + 1 == 3),
               "check_test\\.cc:[0-9]+: check failed: 1 \\+ 1 == 3");
}

TEST(CheckDeathTest, ComparingChecksPrintBothOperands) {
  const int a = 4;
  EXPECT_DEATH(RTB_CHECK_EQ(a, 5), "a == 5 \\(4 vs\\. 5\\)");
  EXPECT_DEATH(RTB_CHECK_LT(a, 4), "a < 4 \\(4 vs\\. 4\\)");
  EXPECT_DEATH(RTB_CHECK_LE(a, 3), "a <= 3 \\(4 vs\\. 3\\)");
  EXPECT_DEATH(RTB_CHECK_GT(a, 4), "a > 4 \\(4 vs\\. 4\\)");
  EXPECT_DEATH(RTB_CHECK_GE(a, 5), "a >= 5 \\(4 vs\\. 5\\)");
}

TEST(Check, HoldsAndEvaluatesItsOperandsOnce) {
  int calls = 0;
  const auto next = [&] { return ++calls; };
  RTB_CHECK(next() == 1);
  RTB_CHECK_EQ(next(), 2);
  RTB_CHECK_LE(next(), 3);
  EXPECT_EQ(calls, 3);
}

}  // namespace
}  // namespace rtb
