#include "core/math/discrete.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace rtb {
namespace {

int SizeOf(const std::vector<float>& cdf) {
  return static_cast<int>(cdf.size()) - 1;
}

TEST(DiscreteTest, CdfIsTheRunningShare) {
  // 1 + 3 + 0 + 4 = 8.
  const std::vector<double> weights = {1, 3, 0, 4};
  std::vector<float> cdf(5);
  EXPECT_EQ(FillCdf(weights, cdf), 8);
  EXPECT_EQ(cdf, (std::vector<float>{0, 0.125f, 0.5f, 0.5f, 1}));
  EXPECT_EQ(MakeCdf(weights), cdf);
  EXPECT_EQ(DiscreteProbability(cdf.data(), 1), 0.375f);
}

TEST(DiscreteTest, EachEntryIsChosenByItsShare) {
  const auto cdf = MakeCdf(std::vector<double>{1, 3, 0, 4});
  int counts[4] = {};
  for (int i = 0; i < 800; ++i) {
    const float u = (static_cast<float>(i) + 0.5f) / 800;
    const DiscreteSample s = SampleDiscrete(cdf.data(), 4, u);
    ++counts[s.index];
    EXPECT_EQ(s.probability, DiscreteProbability(cdf.data(), s.index));
    // The fraction puts u back where it was.
    EXPECT_NEAR(
        cdf[static_cast<std::size_t>(s.index)] + s.fraction * s.probability, u,
        1e-7f);
    EXPECT_GE(s.fraction, 0);
    EXPECT_LT(s.fraction, 1);
  }
  EXPECT_EQ(counts[0], 100);
  EXPECT_EQ(counts[1], 300);
  EXPECT_EQ(counts[2], 0);
  EXPECT_EQ(counts[3], 400);
}

TEST(DiscreteTest, NoWeightMeansEqualShares) {
  const auto cdf = MakeCdf(std::vector<double>(5, 0.0));
  for (int i = 0; i < 5; ++i) {
    EXPECT_NEAR(DiscreteProbability(cdf.data(), i), 0.2f, 1e-7f);
  }
}

// Zeros at both ends, and weights too small for a float's share of 1: never
// chosen, whatever u is, down to 0 and up to the last number below 1.
TEST(DiscreteTest, NeverChoosesTheImpossible) {
  const auto cdf = MakeCdf(std::vector<double>{0, 0, 1, 1e-30, 5, 1e-30, 0});
  for (const float u : {0.0f, 0x1p-24f, 1 / 6.0f, 0.5f, 0x1.fffffep-1f}) {
    const DiscreteSample s = SampleDiscrete(cdf.data(), SizeOf(cdf), u);
    EXPECT_TRUE(s.index == 2 || s.index == 4) << u << " " << s.index;
    EXPECT_GT(s.probability, 0);
  }
}

TEST(DiscreteTest, HugeAndTinyWeights) {
  const auto cdf = MakeCdf(std::vector<double>{1e300, 1e300});
  EXPECT_EQ(cdf[1], 0.5f);
  EXPECT_EQ(MakeCdf(std::vector<double>{1e-300}), (std::vector<float>{0, 1}));
}

TEST(DiscreteDeathTest, RefusesWhatIsNoWeight) {
  EXPECT_DEATH(MakeCdf(std::vector<double>{}), "weights");
  EXPECT_DEATH(MakeCdf(std::vector<double>{1, -1}), "weight");
  EXPECT_DEATH(MakeCdf(std::vector<double>{std::nan("")}), "weight");
}

}  // namespace
}  // namespace rtb
