#include "encoders/adaptive/gain_threshold.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "core/math/random.h"

namespace rtb {
namespace {

/// Over 20 powers of 10, as gains are.
std::vector<float> Gains(int count) {
  std::vector<float> gains;
  for (int i = 0; i < count; ++i) {
    const auto place = static_cast<std::uint32_t>(i);
    gains.push_back(
        std::pow(10.0f, 20 * UnitFloat(RandomBits(place, 0, 0, 4)) - 10));
  }
  return gains;
}

TEST(GainThreshold, BoundsTheNthLargestGain) {
  std::vector<float> gains = Gains(300);
  GainThreshold threshold;
  for (const float gain : gains) threshold.Add(gain);
  std::ranges::sort(gains, std::greater<>());
  for (int n = 1; n <= 300; ++n) {
    const auto [from, to, above] = threshold.Of(n);
    const float gain = gains[static_cast<std::size_t>(n) - 1];
    EXPECT_GE(gain, from);
    EXPECT_LT(gain, to);
    EXPECT_LE(to, from * 1.0626f);  // 17/16
    EXPECT_EQ(above, std::ranges::count_if(gains, [to = to](float other) {
                return other >= to;
              }));
  }
}

TEST(GainThreshold, IsWideOpenWithFewer) {
  GainThreshold threshold;
  threshold.Add(2);
  threshold.Add(3);
  const auto [from, to, above] = threshold.Of(3);
  EXPECT_EQ(from, 0);
  EXPECT_EQ(to, std::numeric_limits<float>::infinity());
  EXPECT_EQ(above, 0);
}

TEST(GainThreshold, TellsAClassFromTheNext) {
  GainThreshold threshold;
  threshold.Add(std::nextafter(1.0f, 0.0f));
  threshold.Add(1);
  EXPECT_EQ(threshold.Of(1).from, 1);
  EXPECT_EQ(threshold.Of(2).to, 1);
  EXPECT_EQ(threshold.Of(2).above, 1);
}

TEST(GainThreshold, CountsZeros) {
  GainThreshold threshold;
  threshold.Add(0);
  threshold.Add(1);
  EXPECT_EQ(threshold.Of(2).from, 0);
  EXPECT_GT(threshold.Of(2).to, 0);
  EXPECT_EQ(threshold.Of(2).above, 1);
}

}  // namespace
}  // namespace rtb
