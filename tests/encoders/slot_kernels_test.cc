// Every vector instruction set finds what plain loops over the slots do, bit
// for bit.
#include "encoders/adaptive/slot_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/math/random.h"
#include "tests/simd_targets.h"

namespace rtb {
namespace {

constexpr float kCellWidth = 8;
constexpr float kLeast = 1e-6f;

float Unit(std::size_t index, std::uint32_t dimension) {
  return UnitFloat(
      RandomBits(static_cast<std::uint32_t>(index), dimension, 0, 9));
}

CellSlots RandomSlots() {
  CellSlots slots;
  for (std::size_t i = 0; i < kSlots; ++i) {
    slots.contrast[i] = Unit(i, 0);
    slots.distance2[i] = 40 * Unit(i, 1);
    slots.extent[i] = Unit(i, 2);
  }
  return slots;
}

CellGains GainsOf(const CellSlots& slots) {
  CellGains gains;
  for (std::size_t i = 0; i < kSlots; ++i) {
    gains[i] = Gain(slots.contrast[i], slots.distance2[i], slots.extent[i]);
  }
  return gains;
}

int FirstLargest(const CellGains& gains) {
  return static_cast<int>(std::ranges::max_element(gains) - gains.begin());
}

TEST(SlotKernels, FindTheGainsOfACell) {
  const CellSlots slots = RandomSlots();
  const CellGains expected = GainsOf(slots);
  ForEachSimdTarget([&] {
    CellGains gains{};
    EXPECT_EQ(FindGains(slots, gains), FirstLargest(expected));
    EXPECT_EQ(gains, expected);
  });
}

TEST(SlotKernels, FindTheFirstOfEqualGains) {
  CellSlots slots;
  slots.contrast.fill(1);
  slots.distance2.fill(2);
  slots.extent.fill(1);
  slots.contrast.fill(0.5f);
  slots.contrast[21] = slots.contrast[30] = 1;
  ForEachSimdTarget([&] {
    CellGains gains{};
    EXPECT_EQ(FindGains(slots, gains), 21);
  });
}

TEST(SlotKernels, ExpectASample) {
  const V2f position(0.3f, 0.7f);
  CellSlots expected = RandomSlots();
  for (int slot = 0; slot < kSlots; ++slot) {
    const V2f center = SlotCenter(slot);
    const float dx = (center.x - position.x) * kCellWidth;
    const float dy = (center.y - position.y) * kCellHeight;
    float& distance2 = expected.distance2[static_cast<std::size_t>(slot)];
    distance2 = std::min(distance2, dx * dx + dy * dy);
  }
  const CellGains expected_gains = GainsOf(expected);
  ASSERT_NE(expected.distance2, RandomSlots().distance2);
  ForEachSimdTarget([&] {
    CellSlots slots = RandomSlots();
    CellGains gains{};
    EXPECT_EQ(ExpectSample(position, kCellWidth, slots, gains),
              FirstLargest(expected_gains));
    EXPECT_EQ(slots.distance2, expected.distance2);
    EXPECT_EQ(gains, expected_gains);
  });
}

/// Rows of random slots, with a border.
struct Plane {
  static constexpr int kColumns = 21, kRows = 5;
  static constexpr std::size_t kStride = kColumns + 2 + kSlotRoom;
  static constexpr std::size_t kSize = kStride * (kRows + 2);

  Plane() {
    for (std::size_t i = 0; i < kSize; ++i) {
      distance2[i] = 60 * Unit(i, 3);
      r[i] = Unit(i, 4);
      g[i] = Unit(i, 5);
      b[i] = Unit(i, 6);
      extent[i] = Unit(i, 7);
    }
  }

  static std::size_t At(int x, int y) {
    return static_cast<std::size_t>(y + 1) * kStride +
           static_cast<std::size_t>(x + 1);
  }

  SlotRows From(int left, int top, int columns, int rows) {
    const std::size_t at = At(left, top);
    return {kStride, columns, rows, &distance2[at], &r[at], &g[at], &b[at]};
  }

  std::vector<float> distance2 = std::vector<float>(kSize);
  std::vector<float> r = distance2, g = distance2, b = distance2;
  std::vector<float> extent = distance2;
};

TEST(SlotKernels, EnterASampleIntoAWindowAndNowhereElse) {
  const EnteredSample sample{V2f(8.4f, 2.6f), V2f(2, 2),
                             Rgb(0.25f, 0.5f, 0.75f), 3, 1};
  constexpr int kWide = 10, kHigh = 3;
  Plane expected;
  int changed = 0;
  for (int y = 1; y < 1 + kHigh; ++y) {
    for (int x = 3; x < 3 + kWide; ++x) {
      const float dx = (3 + 0.5f - sample.at.x + static_cast<float>(x - 3)) * 2;
      const float dy = (static_cast<float>(y) + 0.5f - sample.at.y) * 2;
      const std::size_t at = Plane::At(x, y);
      if (!(dx * dx + dy * dy < expected.distance2[at])) continue;
      expected.distance2[at] = dx * dx + dy * dy;
      expected.r[at] = 0.25f;
      expected.g[at] = 0.5f;
      expected.b[at] = 0.75f;
      ++changed;
    }
  }
  ASSERT_GT(changed, 5);
  ASSERT_LT(changed, kWide * kHigh);
  ForEachSimdTarget([&] {
    Plane plane;
    EnterSample(sample, plane.From(3, 1, kWide, kHigh));
    EXPECT_EQ(plane.distance2, expected.distance2);
    EXPECT_EQ(plane.r, expected.r);
    EXPECT_EQ(plane.g, expected.g);
    EXPECT_EQ(plane.b, expected.b);
  });
}

/// Squared distance of the colors of two slots.
float Apart(const Plane& plane, std::size_t i, std::size_t j) {
  const float dr = plane.r[i] - plane.r[j];
  const float dg = plane.g[i] - plane.g[j];
  const float db = plane.b[i] - plane.b[j];
  return dr * dr + dg * dg + db * db;
}

TEST(SlotKernels, CompareNeighbors) {
  Plane plane;
  for (const bool root : {false, true}) {
    ForEachSimdTarget([&] {
      std::vector<float> contrast(Plane::kSize);
      std::vector<float> best(Plane::kColumns + kSlotRoom);
      const std::size_t first = Plane::At(0, 0);
      CompareSlots(plane.From(0, 0, Plane::kColumns, Plane::kRows), kLeast,
                   root, {&plane.extent[first], &contrast[first], best.data()});
      for (int x = 0; x < Plane::kColumns; ++x) {
        float most = 0;
        for (int y = 0; y < Plane::kRows; ++y) {
          const std::size_t at = Plane::At(x, y);
          float expected =
              std::max(Apart(plane, at - 1, at + 1),
                       Apart(plane, at - Plane::kStride, at + Plane::kStride)) +
              kLeast;
          if (root) expected = std::sqrt(expected);
          EXPECT_EQ(contrast[at], expected);
          most = std::max(
              most, Gain(expected, plane.distance2[at], plane.extent[at]));
        }
        EXPECT_EQ(best[static_cast<std::size_t>(x)], most);
      }
    });
  }
}

}  // namespace
}  // namespace rtb
