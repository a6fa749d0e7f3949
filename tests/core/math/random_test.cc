#include "core/math/random.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

namespace rtb {
namespace {

constexpr int kBins = 64;
constexpr int kDraws = 64 * 1000;

/// Pearson's statistic of counts that should be equal.
template <std::size_t kCount>
double ChiSquare(const std::array<int, kCount>& counts, int draws) {
  const double expected = static_cast<double>(draws) / kCount;
  double sum = 0;
  for (const int count : counts) {
    sum += (count - expected) * (count - expected) / expected;
  }
  return sum;
}

/// The mean of chi-square with k - 1 degrees of freedom is k - 1, its variance
/// 2 (k - 1); five deviations either way. Far too even counts fail as well.
void ExpectUniform(double chi_square, double bins) {
  const double spread = 5 * std::sqrt(2 * (bins - 1));
  EXPECT_GT(chi_square, bins - 1 - spread);
  EXPECT_LT(chi_square, bins - 1 + spread);
}

std::size_t Bin(std::uint32_t bits) {
  return static_cast<std::size_t>(UnitFloat(bits) * kBins);
}

/// Chi-square of one argument running while the others stand still.
template <class Draw>
double ChiSquareOver(const Draw& draw) {
  std::array<int, kBins> counts{};
  for (std::uint32_t i = 0; i < kDraws; ++i) ++counts[Bin(draw(i))];
  return ChiSquare(counts, kDraws);
}

TEST(RandomBits, UniformOverEachArgument) {
  ExpectUniform(
      ChiSquareOver([](std::uint32_t i) { return RandomBits(i, 3, 5, 1); }),
      kBins);
  ExpectUniform(
      ChiSquareOver([](std::uint32_t i) { return RandomBits(9, i, 5, 1); }),
      kBins);
  ExpectUniform(
      ChiSquareOver([](std::uint32_t i) { return RandomBits(9, 3, i, 1); }),
      kBins);
  ExpectUniform(
      ChiSquareOver([](std::uint32_t i) { return RandomBits(9, 3, 5, i); }),
      kBins);
  // The upper half of a seed counts as much as the lower.
  ExpectUniform(ChiSquareOver([](std::uint32_t i) {
                  return RandomBits(9, 3, 5, std::uint64_t{i} << 32);
                }),
                kBins);
}

// Pairs in an 8 x 8 grid: were one dimension a function of the other, whole
// squares of it would stay empty.
TEST(RandomBits, DimensionsAreIndependent) {
  for (const std::uint32_t other : {1u, 2u, 7u, 64u}) {
    std::array<int, 64> counts{};
    for (std::uint32_t i = 0; i < kDraws; ++i) {
      const std::size_t a = RandomBits(i / 16, i % 16, 0, 1) >> 29;
      const std::size_t b = RandomBits(i / 16, i % 16, other, 1) >> 29;
      ++counts[a * 8 + b];
    }
    ExpectUniform(ChiSquare(counts, kDraws), 64);
  }
}

TEST(RandomBits, NeighborsAreIndependent) {
  std::array<int, 64> counts{};
  for (std::uint32_t i = 0; i < kDraws; ++i) {
    ++counts[(RandomBits(i, 0, 0, 0) >> 29) * 8 +
             (RandomBits(i + 1, 0, 0, 0) >> 29)];
  }
  ExpectUniform(ChiSquare(counts, kDraws), 64);
}

TEST(RandomBits, DependsOnEveryArgumentAndNothingElse) {
  const std::uint32_t bits = RandomBits(1, 2, 3, 4);
  EXPECT_EQ(RandomBits(1, 2, 3, 4), bits);
  const std::set<std::uint32_t> all = {
      bits,
      RandomBits(2, 2, 3, 4),
      RandomBits(1, 3, 3, 4),
      RandomBits(1, 2, 4, 4),
      RandomBits(1, 2, 3, 5),
      RandomBits(1, 2, 3, 4 + (std::uint64_t{1} << 32))};
  EXPECT_EQ(all.size(), 6u);
}

// Worked by hand from the paper's listing: with v = 0, after the first line
// all four are c = 1013904223. Exact values pin the sequence, and with it every
// committed result.
TEST(Pcg4d, FollowsTheListing) {
  constexpr std::uint32_t c = 1013904223u;
  const std::uint32_t x = c + c * c;
  const std::uint32_t y = c + c * x;
  const std::uint32_t z = c + x * y;
  const std::uint32_t w = c + y * z;
  const std::uint32_t sx = x ^ (x >> 16), sy = y ^ (y >> 16),
                      sz = z ^ (z >> 16), sw = w ^ (w >> 16);
  const std::uint32_t rx = sx + sy * sw;
  const std::uint32_t ry = sy + sz * rx;
  const std::uint32_t rz = sz + rx * ry;
  const std::uint32_t rw = sw + ry * rz;
  const Uint4 v = Pcg4d({0, 0, 0, 0});
  EXPECT_EQ(v.x, rx);
  EXPECT_EQ(v.y, ry);
  EXPECT_EQ(v.z, rz);
  EXPECT_EQ(v.w, rw);
}

TEST(UnitFloat, StaysBelowOne) {
  EXPECT_EQ(UnitFloat(0), 0);
  EXPECT_EQ(UnitFloat(0xFFFFFFFFu), 1 - 0x1p-24f);
  EXPECT_EQ(UnitFloat(0x80000000u), 0.5f);
}

}  // namespace
}  // namespace rtb
