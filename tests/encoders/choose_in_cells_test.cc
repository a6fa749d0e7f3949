// Every vector instruction set chooses the rays of cells that plain loops over
// their slots do, bit for bit.
#include "encoders/adaptive/choose_in_cells.h"

#include <gtest/gtest.h>

#include <utility>

#include "tests/encoders/plain_slots.h"
#include "tests/simd_targets.h"

namespace rtb {
namespace {

constexpr std::size_t kRoom = 64;

CellSlots RandomSlots(std::uint32_t number) {
  const auto unit = [number](std::size_t i, std::uint32_t dimension) {
    return UnitFloat(
        RandomBits(static_cast<std::uint32_t>(i), dimension, number, 9));
  };
  CellSlots slots{};
  for (std::size_t i = 0; i < kSlots; ++i) {
    slots.contrast[i] = unit(i, 0);
    slots.distance2[i] = 40 * unit(i, 1);
    slots.samples[i] = unit(i, 2) < 0.5f ? 0 : unit(i, 3) < 0.7f ? 1 : 2;
  }
  return slots;
}

/// Of all cells.
using Slots = std::vector<CellSlots>;

Slots ManySlots(std::size_t count) {
  Slots slots(count);
  std::uint32_t number = 0;
  for (CellSlots& cell : slots) cell = RandomSlots(number++);
  return slots;
}

/// @param slots has to outlive it.
std::vector<CellChoice> ChoicesIn(const Slots& slots, int most) {
  std::vector<CellChoice> choices;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    const int cell = 4321 + 3 * static_cast<int>(i);
    choices.push_back({&slots[i], cell, static_cast<int>(i % 7), most});
  }
  return choices;
}

ChoiceTerms Terms(float least = 0) {
  return {8, least, (std::uint64_t{7} << 32) + 5};
}

void ExpectPlainRays(const std::vector<CellChoice>& cells,
                     const ChoiceTerms& terms) {
  ForEachSimdTarget([&] {
    std::vector<RayChoice> rays(kRoom * cells.size());
    std::vector<int> counts(cells.size(), -1);
    ChooseInCells(cells, terms, kRoom, rays.data(), counts.data());
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const auto expected = PlainChooseInCell(cells[c], terms);
      ASSERT_EQ(counts[c], static_cast<int>(expected.size())) << c;
      for (std::size_t i = 0; i < expected.size(); ++i) {
        const RayChoice& ray = rays[c * kRoom + i];
        EXPECT_EQ(ray.cell, expected[i].cell);
        EXPECT_EQ(ray.position, expected[i].position) << i;
        EXPECT_EQ(ray.gain, expected[i].gain);
      }
    }
  });
}

TEST(ChooseInCells, ChoosesTheRaysOfThePlainLoops) {
  for (const std::size_t cells :
       {std::size_t{1}, std::size_t{2}, kCellsAtOnce}) {
    const Slots slots = ManySlots(cells);
    for (const int most : {1, 2, 12, 64}) {
      ExpectPlainRays(ChoicesIn(slots, most), Terms());
    }
  }
}

TEST(ChooseInCells, StopsWhereEachCellHasItsMost) {
  const Slots slots = ManySlots(20);
  std::vector<CellChoice> choices = ChoicesIn(slots, 1);
  for (std::size_t i = 0; i < choices.size(); ++i) {
    choices[i].most = 1 + static_cast<int>(i % 5);
  }
  ExpectPlainRays(choices, Terms());
}

TEST(ChooseInCells, StopsBelowTheLeastGain) {
  const Slots slots = ManySlots(20);
  const std::vector<CellChoice> choices = ChoicesIn(slots, 12);
  const std::vector<RayChoice> all = PlainChooseInCell(choices[3], Terms());
  ASSERT_EQ(all.size(), 12u);
  for (const std::size_t last : {0u, 4u, 11u}) {
    const ChoiceTerms terms = Terms(all[last].gain);
    ASSERT_EQ(PlainChooseInCell(choices[3], terms).size(), last + 1);
    ExpectPlainRays(choices, terms);
  }
  const ChoiceTerms terms = Terms(std::nextafter(all[0].gain, 1e9f));
  EXPECT_TRUE(PlainChooseInCell(choices[3], terms).empty());
  ExpectPlainRays(choices, terms);
}

// Of the random numbers of these cells some round to 1 in the last slots.
TEST(ChooseInCells, StaysInsideTheCell) {
  Slots slots(1);
  slots[0] = {};
  slots[0].distance2.fill(1);
  slots[0].samples.fill(1);
  slots[0].contrast.fill(0.5f);
  slots[0].contrast[kSlots - 1] = 1;
  const ChoiceTerms terms = {8, 0, 5};
  for (const auto& [cell, seen] : {std::pair(22697, 5), std::pair(6960, 16)}) {
    const std::vector<CellChoice> choices = {{slots.data(), cell, seen, 1}};
    ExpectPlainRays(choices, terms);
    const V2f place = PlainChooseInCell(choices[0], terms)[0].position;
    EXPECT_GT(std::max(place.x, place.y), 0.9999f);
    EXPECT_LT(std::max(place.x, place.y), 1.0f);
  }
}

// In any two vectors and any two lanes.
TEST(ChooseInCells, TakesTheFirstOfEqualGains) {
  Slots slots(1);
  slots[0] = {};
  slots[0].distance2.fill(400);
  for (std::size_t first = 0; first < kSlots; ++first) {
    for (std::size_t second = first + 1; second < kSlots; ++second) {
      slots[0].contrast.fill(0.5f);
      slots[0].contrast[first] = slots[0].contrast[second] = 1;
      ASSERT_EQ(PlainBest(slots[0]), first);
      ExpectPlainRays(ChoicesIn(slots, 1), Terms());
    }
  }
}

}  // namespace
}  // namespace rtb
