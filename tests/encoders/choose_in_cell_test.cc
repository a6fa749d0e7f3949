// Every vector instruction set chooses the rays of a cell that plain loops over
// its slots do, bit for bit.
#include "encoders/adaptive/choose_in_cell.h"

#include <gtest/gtest.h>

#include "tests/encoders/plain_slots.h"
#include "tests/simd_targets.h"

namespace rtb {
namespace {

CellSlots RandomSlots(std::uint32_t number) {
  const auto unit = [number](std::size_t i, std::uint32_t dimension) {
    return UnitFloat(
        RandomBits(static_cast<std::uint32_t>(i), dimension, number, 9));
  };
  CellSlots slots;
  for (std::size_t i = 0; i < kSlots; ++i) {
    slots.contrast[i] = unit(i, 0);
    slots.distance2[i] = 40 * unit(i, 1);
    slots.extent[i] = unit(i, 2) < 0.5f ? kEmptySlot : unit(i, 3);
  }
  return slots;
}

/// @param slots has to outlive it.
CellChoice ChoiceIn(const CellSlots& slots) {
  CellChoice choice;
  choice.contrast = slots.contrast.data();
  choice.distance2 = slots.distance2.data();
  choice.extent = slots.extent.data();
  choice.cell_width = 8;
  choice.cell = 4321;
  choice.seen = 3;
  choice.most = 12;
  choice.seed = (std::uint64_t{7} << 32) + 5;
  return choice;
}

void ExpectPlainRays(const CellSlots& slots, const CellChoice& choice) {
  const std::vector<RayChoice> expected = PlainChooseInCell(slots, choice);
  ForEachSimdTarget([&] {
    std::vector<RayChoice> rays(static_cast<std::size_t>(choice.most));
    const int count = ChooseInCell(choice, rays.data());
    ASSERT_EQ(count, static_cast<int>(expected.size()));
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_EQ(rays[i].cell, expected[i].cell);
      EXPECT_EQ(rays[i].position, expected[i].position) << i;
      EXPECT_EQ(rays[i].gain, expected[i].gain);
      EXPECT_EQ(rays[i].reach, expected[i].reach);
    }
  });
}

TEST(ChooseInCell, ChoosesTheRaysOfThePlainLoops) {
  for (std::uint32_t i = 0; i < 50; ++i) {
    const CellSlots slots = RandomSlots(i);
    CellChoice choice = ChoiceIn(slots);
    for (const int most : {0, 1, 2, 12, 64}) {
      choice.most = most;
      ExpectPlainRays(slots, choice);
    }
  }
}

TEST(ChooseInCell, StopsBelowTheLeastGain) {
  const CellSlots slots = RandomSlots(3);
  CellChoice choice = ChoiceIn(slots);
  const std::vector<RayChoice> all = PlainChooseInCell(slots, choice);
  ASSERT_EQ(all.size(), 12u);
  for (const std::size_t last : {0u, 4u, 11u}) {
    choice.least = all[last].gain;
    ASSERT_EQ(PlainChooseInCell(slots, choice).size(), last + 1);
    ExpectPlainRays(slots, choice);
  }
  choice.least = std::nextafter(all[0].gain, 1e9f);
  EXPECT_TRUE(PlainChooseInCell(slots, choice).empty());
  ExpectPlainRays(slots, choice);
}

// In any two vectors and any two lanes.
TEST(ChooseInCell, TakesTheFirstOfEqualGains) {
  CellSlots slots;
  slots.distance2.fill(400);
  slots.extent.fill(1);
  for (std::size_t first = 0; first < kSlots; ++first) {
    for (std::size_t second = first + 1; second < kSlots; ++second) {
      slots.contrast.fill(0.5f);
      slots.contrast[first] = slots.contrast[second] = 1;
      CellChoice choice = ChoiceIn(slots);
      choice.most = 1;
      ASSERT_EQ(PlainBest(slots), first);
      ExpectPlainRays(slots, choice);
    }
  }
}

}  // namespace
}  // namespace rtb
