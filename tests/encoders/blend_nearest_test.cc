// Every vector instruction set blends the nearest samples as a plain loop over
// all of them does, bit for bit.
#include "encoders/adaptive/blend_nearest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "core/math/random.h"
#include "tests/simd_targets.h"

namespace rtb {
namespace {

constexpr float kCellWidth = 8;

float Unit(int index, std::uint32_t dimension, std::uint64_t seed) {
  return UnitFloat(
      RandomBits(static_cast<std::uint32_t>(index), dimension, 0, seed));
}

NearSamples Scattered(int count, std::uint64_t seed) {
  NearSamples near;
  for (int i = 0; i < count; ++i) {
    const auto at = [&](std::uint32_t d) { return Unit(i, d, seed); };
    near.Add({24 * at(0) - 8, 32 * at(1) - 8}, {at(2), at(3), at(4)},
             {at(5), at(6), at(7)});
  }
  return near;
}

/// What one place is made of, as the header says it.
struct Expected {
  Rgb encoded{0};
  Rgb linear{0};
  float share = 0;
};

Expected Blend(const NearSamples& near, float x, float y) {
  std::vector<std::pair<float, std::size_t>> sorted;
  for (std::size_t i = 0; i < near.size(); ++i) {
    const float dx = near.x[i] - x;
    const float dy = near.y[i] - y;
    // A quarter of a squared sub-pixel keeps weights finite.
    sorted.emplace_back(dx * dx + dy * dy + 0.25f, i);
  }
  std::ranges::sort(sorted);
  sorted.resize(std::min(sorted.size(), kNearest));
  Expected expected;
  float sum = 0;
  for (const auto& [distance2, i] : sorted) {
    const float weight = 1 / (distance2 * distance2);
    expected.encoded += near.encoded[i] * weight;
    expected.linear += near.linear[i] * weight;
    sum += weight;
    expected.share = 1 / (1 + distance2 / 9);
  }
  expected.encoded /= sum;
  expected.linear /= sum;
  return expected;
}

void ExpectNear(const Rgb& found, const Rgb& expected) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], 2e-3f);
}

TEST(BlendNearest, IsTheMeanOfTheThreeNearest) {
  const BlendPlaces places(8, 16, kCellWidth);
  ASSERT_EQ(places.x.size(), 128u);
  ForEachSimdTarget([&] {
    for (const int count : {1, 2, 3, 7, 60}) {
      const NearSamples near = Scattered(count, 5);
      BlendedPlaces out(places);
      BlendNearest(near, places, out);
      for (std::size_t i = 0; i < places.x.size(); ++i) {
        // Keys lose their lowest 10 of 23 bits, 1e-4, to the index.
        const Expected expected = Blend(near, places.x[i], places.y[i]);
        ExpectNear(out.encoded[i], expected.encoded);
        ExpectNear(out.linear[i], expected.linear);
        EXPECT_NEAR(out.share[i], expected.share, 2e-3f);
      }
    }
  });
}

TEST(BlendNearest, GivesTheSameBitsOnEveryTarget) {
  const BlendPlaces places(5, 7, kCellWidth);  // 35 of 48 places are real.
  ASSERT_EQ(places.x.size(), 48u);
  const NearSamples near = Scattered(200, 9);
  BlendedPlaces first(places);
  BlendNearest(near, places, first);
  ForEachSimdTarget([&] {
    BlendedPlaces out(places);
    BlendNearest(near, places, out);
    EXPECT_EQ(out.encoded, first.encoded);
    EXPECT_EQ(out.linear, first.linear);
    EXPECT_EQ(out.share, first.share);
  });
}

TEST(BlendNearest, TakesTheEarlierOfEqualSamples) {
  const BlendPlaces places(1, 1, kCellWidth);  // One place, (4, 8).
  NearSamples near;
  // Four samples at a distance of 1; the last does not count.
  near.Add({3, 8}, Rgb(0.25f), Rgb(0.5f));
  near.Add({5, 8}, Rgb(0.25f), Rgb(0.5f));
  near.Add({4, 7}, Rgb(0.25f), Rgb(0.5f));
  near.Add({4, 9}, Rgb(1), Rgb(1));
  BlendedPlaces out(places);
  BlendNearest(near, places, out);
  EXPECT_EQ(out.encoded[0], Rgb(0.25f));
  EXPECT_EQ(out.linear[0], Rgb(0.5f));
}

}  // namespace
}  // namespace rtb
