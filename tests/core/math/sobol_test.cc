#include "core/math/sobol.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>
#include <utility>

namespace rtb {
namespace {

/// Whether 2^k points from `first` hold one in each elementary interval of
/// 2^-a x 2^-(k - a), for every a.
template <class Point>
bool IsNet(std::uint32_t first, int k, Point point) {
  const std::uint32_t count = 1u << k;
  for (int a = 0; a <= k; ++a) {
    std::set<std::pair<int, int>> intervals;
    for (std::uint32_t i = first; i < first + count; ++i) {
      const V2f p = point(i);
      intervals.insert({static_cast<int>(std::ldexp(p.x, a)),
                        static_cast<int>(std::ldexp(p.y, k - a))});
    }
    if (intervals.size() != count) return false;
  }
  return true;
}

/// Unscrambled coordinate.
float Plain(std::uint32_t index, int dimension) {
  return UnitFloat(ReverseBits(SobolReversed(index, dimension)));
}

// The first points of the sequence in natural (not Gray code) order. They
// follow from m: dimension 2 has m = 1, 3, 5, dimension 3 has m = 1, 3, 3 and
// dimension 4 has m = 1, 3, 1: point 2^k is m_(k + 1) / 2^(k + 1), and others
// are the exclusive or of these fractions.
TEST(SobolTest, FirstPointsFollowFromTheDirectionNumbers) {
  const float expected[8][4] = {
      {0, 0, 0, 0},
      {0.5f, 0.5f, 0.5f, 0.5f},
      {0.25f, 0.75f, 0.75f, 0.75f},
      {0.75f, 0.25f, 0.25f, 0.25f},
      {0.125f, 0.625f, 0.375f, 0.125f},
      {0.625f, 0.125f, 0.875f, 0.625f},
      {0.375f, 0.375f, 0.625f, 0.875f},
      {0.875f, 0.875f, 0.125f, 0.375f},
  };
  for (std::uint32_t i = 0; i < 8; ++i) {
    for (int d = 0; d < 4; ++d) {
      EXPECT_EQ(Plain(i, d), expected[i][d]) << i << " " << d;
    }
  }
}

// Look-ups by bytes are sums over the bits that are set.
TEST(SobolTest, PointsAreSumsOfDirectionNumbers) {
  constexpr SobolDirections kDirections = MakeSobolDirections();
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const std::uint32_t index = RandomBits(i, 0, 0, 0);
    EXPECT_EQ(SobolReversed(index, 0), index);
    for (int dimension = 1; dimension < 4; ++dimension) {
      std::uint32_t sum = 0;
      for (int bit = 0; bit < 32; ++bit) {
        if ((index >> bit) & 1u) {
          sum ^= kDirections.reversed[dimension - 1][bit];
        }
      }
      EXPECT_EQ(SobolReversed(index, dimension), sum);
    }
  }
}

TEST(SobolTest, FirstTwoDimensionsAreNetsUpToTwoToTheTwelfth) {
  for (int k = 0; k <= 12; ++k) {
    EXPECT_TRUE(IsNet(0, k, [](std::uint32_t i) {
      return V2f(Plain(i, 0), Plain(i, 1));
    })) << k;
  }
}

TEST(SobolTest, ScrambledPointsAreNetsInEveryAlignedRun) {
  for (const std::uint32_t seed : {0u, 1u, 2u, 0xDEADBEEFu, 0xFFFFFFFFu}) {
    for (int k = 0; k <= 8; ++k) {
      for (const std::uint32_t run : {0u, 1u, 5u, (0xFFFFFFFFu >> k) - 1}) {
        EXPECT_TRUE(IsNet(run << k, k,
                          [&](std::uint32_t i) { return SobolOwen2(i, seed); }))
            << seed << " " << k << " " << run;
        EXPECT_TRUE(IsNet(run << k, k,
                          [&](std::uint32_t i) {
                            const V4f p = SobolOwen4(i, seed);
                            return V2f(p.x, p.y);
                          }))
            << seed << " " << k << " " << run;
      }
    }
  }
}

TEST(SobolTest, EachOfFourDimensionsIsStratified) {
  for (int d = 0; d < 4; ++d) {
    std::set<int> strips;
    for (std::uint32_t i = 0; i < 1024; ++i) {
      const float x = SobolOwen4(i, 7)[d];
      EXPECT_GE(x, 0);
      EXPECT_LT(x, 1);
      strips.insert(static_cast<int>(x * 1024));
    }
    EXPECT_EQ(strips.size(), 1024u) << d;
  }
}

// Over seeds, one sample is uniform on the square: 20,000 of them in 10 x 10
// boxes give chi^2 with 99 degrees of freedom, of mean 99 and deviation 14.1;
// 99 + 5 deviations = 169.
TEST(SobolTest, AnySampleIsUniformOverSeeds) {
  for (const std::uint32_t index : {0u, 1u, 13u}) {
    int counts[10][10] = {};
    constexpr int kSeeds = 20000;
    for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
      const V2f p = SobolOwen2(index, seed);
      ++counts[static_cast<int>(p.x * 10)][static_cast<int>(p.y * 10)];
    }
    double chi2 = 0;
    for (const auto& row : counts) {
      for (const int count : row) {
        chi2 += std::pow(count - kSeeds / 100.0, 2) / (kSeeds / 100.0);
      }
    }
    EXPECT_LT(chi2, 169) << index;
  }
}

/// Pearson correlation of f and g over `count` arguments.
template <class F, class G>
double Correlation(int count, F f, G g) {
  double sf = 0, sg = 0, sff = 0, sgg = 0, sfg = 0;
  for (int i = 0; i < count; ++i) {
    const double a = f(static_cast<std::uint32_t>(i));
    const double b = g(static_cast<std::uint32_t>(i));
    sf += a;
    sg += b;
    sff += a * a;
    sgg += b * b;
    sfg += a * b;
  }
  const double n = count;
  return (sfg - sf * sg / n) /
         std::sqrt((sff - sf * sf / n) * (sgg - sg * sg / n));
}

// Independent series of 10,000 correlate by 0.01 at one deviation. Seeds that
// differ by one bit, high or low, are the hard case; so are the dimension
// sets of a pixel and neighboring pixels.
TEST(SobolTest, SeedsAndDimensionsAreIndependent) {
  const auto x_of = [](std::uint32_t seed, std::uint32_t index) {
    return SobolOwen2(index, seed).x;
  };
  for (const std::uint32_t bit : {1u, 1u << 15, 1u << 31}) {
    for (const std::uint32_t index : {0u, 3u}) {
      const double r = Correlation(
          10000,
          [&](std::uint32_t s) { return x_of(SobolSeed(s, 0, 1), index); },
          [&](std::uint32_t s) {
            return x_of(SobolSeed(s, 0, 1) ^ bit, index);
          });
      EXPECT_LT(std::abs(r), 0.04) << bit << " " << index;
    }
  }
  const double sets = Correlation(
      10000, [&](std::uint32_t s) { return x_of(SobolSeed(s, 0, 1), 0); },
      [&](std::uint32_t s) { return x_of(SobolSeed(s, 1, 1), 0); });
  EXPECT_LT(std::abs(sets), 0.04);
  const double pixels = Correlation(
      10000, [&](std::uint32_t s) { return x_of(SobolSeed(s, 0, 1), 0); },
      [&](std::uint32_t s) { return x_of(SobolSeed(s + 1, 0, 1), 0); });
  EXPECT_LT(std::abs(pixels), 0.04);
}

// Padding: along one pixel's samples, two dimension sets must not march in
// step (which equal orders of the points would make them do).
TEST(SobolTest, DimensionSetsOfAPixelAreShuffledApart) {
  int high = 0;
  for (std::uint32_t pixel = 0; pixel < 200; ++pixel) {
    const double r = Correlation(
        256,
        [&](std::uint32_t i) {
          return SobolOwen2(i, SobolSeed(pixel, 0, 0)).x;
        },
        [&](std::uint32_t i) {
          return SobolOwen2(i, SobolSeed(pixel, 1, 0)).x;
        });
    // Of a random order the deviation is 1/16: 3 deviations are 0.1875.
    if (std::abs(r) > 0.1875) ++high;
  }
  EXPECT_LE(high, 20);
}

/// Root mean square error over seeds of the mean of 256 samples of
/// sin(pi x) sin(pi y), whose integral is (2 / pi)^2.
template <class Point>
double IntegrationError(Point point) {
  constexpr double kPi = std::numbers::pi;
  double squares = 0;
  for (std::uint32_t seed = 0; seed < 64; ++seed) {
    double sum = 0;
    for (std::uint32_t i = 0; i < 256; ++i) {
      const V2f p = point(i, seed);
      sum += std::sin(kPi * p.x) * std::sin(kPi * p.y);
    }
    squares += std::pow(sum / 256 - 4 / (kPi * kPi), 2);
  }
  return std::sqrt(squares / 64);
}

// Random: deviation sqrt(1/4 - (2/pi)^4) / 16 = 0.0183. A scrambled net of n
// points has O(n^-3/2 log n): at n = 256 well below a thirtieth of that.
TEST(SobolTest, SmoothIntegralsConvergeMuchFasterThanRandom) {
  const double random = IntegrationError([](std::uint32_t i, std::uint32_t s) {
    return V2f(UnitFloat(RandomBits(i, s, 0, 0)),
               UnitFloat(RandomBits(i, s, 1, 0)));
  });
  EXPECT_NEAR(random, 0.0183, 0.005);
  EXPECT_LT(IntegrationError(SobolOwen2), random / 30);
}

}  // namespace
}  // namespace rtb
