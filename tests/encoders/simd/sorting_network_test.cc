#include "encoders/simd/sorting_network.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>

#include "core/math/random.h"

namespace rtb {
namespace {

// What sorts all sequences of zeros and ones sorts everything (Knuth, 5.3.4,
// theorem Z). Bit i is value i: a step may only turn (1, 0) into (0, 1).
template <std::size_t kCount>
bool Sorts(std::uint32_t bits) {
  const auto& network = kSortingNetwork<kCount>;
  const int ones = std::popcount(bits);
  for (std::size_t i = 0; i < network.size; ++i) {
    const std::uint32_t low = std::uint32_t{1} << network.low[i];
    const std::uint32_t high = std::uint32_t{1} << network.high[i];
    if ((bits & low) != 0 && (bits & high) == 0) bits ^= low | high;
  }
  std::uint32_t sorted = 0;
  for (int i = 0; i < ones; ++i) {
    sorted |= std::uint32_t{1} << (kCount - 1 - static_cast<std::size_t>(i));
  }
  return bits == sorted;
}

TEST(SortingNetworkTest, SortsAllZerosAndOnesOfSixteen) {
  for (std::uint32_t bits = 0; bits < 1u << 16; ++bits) {
    ASSERT_TRUE(Sorts<16>(bits)) << bits;
  }
}

TEST(SortingNetworkTest, SortsZerosAndOnesOfThirtyTwo) {
  for (std::uint32_t i = 0; i < 1'000'000; ++i) {
    const std::uint32_t bits = RandomBits(i, 0, 0, 0);
    ASSERT_TRUE(Sorts<32>(bits)) << bits;
  }
}

// 191 steps: Knuth's table in 5.3.4 for Batcher's method.
TEST(SortingNetworkTest, TakesAsFewStepsAsBatcherSays) {
  EXPECT_EQ(kSortingNetwork<16>.size, 63u);
  EXPECT_EQ(kSortingNetwork<32>.size, 191u);
}

}  // namespace
}  // namespace rtb
