#include "core/math/sampling.h"

#include <gtest/gtest.h>

#include <set>

namespace rtb {
namespace {

/// How many of `count` equal strips the samples visit along one axis.
std::size_t StripsVisited(std::uint32_t count, int axis,
                          std::uint32_t pattern) {
  std::set<int> strips;
  for (std::uint32_t i = 0; i < count; ++i) {
    const V2f p = MultiJittered(i, count, pattern);
    strips.insert(static_cast<int>(p[axis] * static_cast<float>(count)));
  }
  return strips.size();
}

TEST(MultiJitteredTest, SquareCountsAreStratifiedAsGridAndInEachAxis) {
  for (const std::uint32_t pattern : {0u, 1u, 77u}) {
    EXPECT_EQ(StripsVisited(64, 0, pattern), 64u);
    EXPECT_EQ(StripsVisited(64, 1, pattern), 64u);
    std::set<int> squares;
    for (std::uint32_t i = 0; i < 64; ++i) {
      const V2f p = MultiJittered(i, 64, pattern);
      squares.insert(static_cast<int>(p.x * 8) * 8 + static_cast<int>(p.y * 8));
    }
    EXPECT_EQ(squares.size(), 64u);
  }
}

TEST(MultiJitteredTest, AnyCountStaysInTheSquareAndStratifiedDownwards) {
  for (std::uint32_t count = 1; count < 40; ++count) {
    EXPECT_EQ(StripsVisited(count, 1, 5), count);
    for (std::uint32_t i = 0; i < count; ++i) {
      const V2f p = MultiJittered(i, count, 5);
      EXPECT_GE(p.x, 0);
      EXPECT_LT(p.x, 1);
      EXPECT_GE(p.y, 0);
      EXPECT_LT(p.y, 1);
    }
  }
}

TEST(MultiJitteredTest, PermutationsHoldForKeysNearTheEndOfTheirRange) {
  for (const std::uint32_t key : {0u, 5u, 0xFFFFFFFFu, 0xFFFFFFF0u}) {
    std::set<std::uint32_t> seen;
    for (std::uint32_t i = 0; i < 37; ++i) seen.insert(Permute(i, 37, key));
    EXPECT_EQ(seen.size(), 37u);
    EXPECT_LT(*seen.rbegin(), 37u);
  }
}

TEST(MultiJitteredTest, PatternsDifferAndRepeat) {
  EXPECT_EQ(MultiJittered(3, 16, 9), MultiJittered(3, 16, 9));
  EXPECT_NE(MultiJittered(3, 16, 9), MultiJittered(3, 16, 10));
}

}  // namespace
}  // namespace rtb
