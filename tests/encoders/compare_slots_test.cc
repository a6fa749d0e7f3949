// Every vector instruction set finds what plain loops over the slots do, bit
// for bit.
#include <gtest/gtest.h>

#include "tests/encoders/slot_plane.h"
#include "tests/simd_targets.h"

namespace rtb {
namespace {

/// Squared distance of two colors.
float Apart(std::uint32_t a, std::uint32_t b) {
  int sum = 0;
  for (int shift = 0; shift < 3 * kChannelBits; shift += kChannelBits) {
    const auto channel = [shift](std::uint32_t color) {
      return static_cast<int>(color >> shift & ((1u << kChannelBits) - 1));
    };
    sum += (channel(a) - channel(b)) * (channel(a) - channel(b));
  }
  return static_cast<float>(sum) * (1 / (kChannelMost * kChannelMost));
}

/// The contrasts of one cell and its best gain.
float PlainCompare(int column, int row, bool root, SlotPlane& plane) {
  CellSlots& cell =
      plane.cells[static_cast<std::size_t>(plane.grid.At(column, row))];
  const auto at = static_cast<std::size_t>(plane.grid.At(column, row));
  std::fill_n(&plane.gains[at * kBlocks], kBlocks, 0.0f);
  for (std::size_t slot = 0; slot < kSlots; ++slot) {
    const int x = column * kSlotColumns + static_cast<int>(slot) % kSlotColumns;
    const int y = row * kSlotRows + static_cast<int>(slot) / kSlotColumns;
    const float contrast =
        std::max(Apart(plane.Color(x - 1, y), plane.Color(x + 1, y)),
                 Apart(plane.Color(x, y - 1), plane.Color(x, y + 1))) +
        kLeast;
    cell.contrast[slot] = root ? contrast : contrast * contrast;
    float& best = plane.gains[at * kBlocks + slot / kBlockSlots];
    best = std::max(best, Gain(cell.contrast[slot], cell.distance2[slot],
                               ExtentOf(cell.samples[slot])));
  }
  return std::max(plane.gains[at * kBlocks], plane.gains[at * kBlocks + 1]);
}

/// The best gains of a row before it is compared.
const std::vector<float> kOld(SlotPlane::kColumns);

/// A slot of each block.
constexpr std::uint32_t kBothBlocks = 1u << 9 | 1u << 22;

TEST(CompareSlots, ComparesNeighbors) {
  for (const bool root : {false, true}) {
    for (int row = 0; row < SlotPlane::kRows; ++row) {
      SlotPlane expected;
      std::ranges::fill(expected.changed, kBothBlocks);
      std::ranges::fill(expected.farthest, -1.0f);
      std::vector<float> expected_best = kOld;
      for (int column = 0; column < SlotPlane::kColumns; ++column) {
        expected_best[static_cast<std::size_t>(column)] =
            PlainCompare(column, row, root, expected);
        expected.Bound(column, row);
      }
      ForEachSimdTarget([&] {
        SlotPlane plane;
        std::ranges::fill(plane.changed, kBothBlocks);
        std::ranges::fill(plane.farthest, -1.0f);
        std::vector<float> best = kOld;
        CompareSlots(plane.Slots(), row, kLeast, root, best.data());
        ExpectSame(plane, expected);
        EXPECT_EQ(best, expected_best);
      });
    }
  }
}

/// Which blocks of row 1 are compared where one slot has changed: of each cell
/// 0, 1 (the upper one), 2 or both.
std::vector<int> ComparedAfter(int x, int y) {
  SlotPlane plane;
  plane.changed[plane.Cell(x, y)] = 1u << SlotPlane::InCell(x, y);
  std::vector<float> best = kOld;
  CompareSlots(plane.Slots(), 1, kLeast, false, best.data());
  std::vector<int> compared;
  for (int column = 0; column < SlotPlane::kColumns; ++column) {
    const float* const gains = &plane.gains[static_cast<std::size_t>(
        plane.grid.At(column, 1) * kBlocks)];
    compared.push_back((gains[0] >= 0 ? 1 : 0) + (gains[1] >= 0 ? 2 : 0));
  }
  return compared;
}

TEST(CompareSlots, ComparesWhatChangedOrLiesBesideIt) {
  constexpr int kX = 2 * kSlotColumns;  // Of the third cell.
  constexpr int kY = kSlotRows;
  using Blocks = std::vector<int>;
  EXPECT_EQ(ComparedAfter(kX + 1, kY + 2), (Blocks{0, 0, 1, 0, 0}));
  EXPECT_EQ(ComparedAfter(kX + 1, kY + 3), (Blocks{0, 0, 3, 0, 0}));
  EXPECT_EQ(ComparedAfter(kX + 1, kY + 4), (Blocks{0, 0, 3, 0, 0}));
  EXPECT_EQ(ComparedAfter(kX + 1, kY + 5), (Blocks{0, 0, 2, 0, 0}));
  EXPECT_EQ(ComparedAfter(kX, kY + 2), (Blocks{0, 1, 1, 0, 0}));
  EXPECT_EQ(ComparedAfter(kX + 3, kY + 6), (Blocks{0, 0, 2, 2, 0}));
  EXPECT_EQ(ComparedAfter(kX + 1, kY - 1), (Blocks{0, 0, 1, 0, 0}));
  EXPECT_EQ(ComparedAfter(kX + 1, kY + kSlotRows), (Blocks{0, 0, 2, 0, 0}));
  EXPECT_EQ(ComparedAfter(kX + 1, kY - 2), (Blocks{0, 0, 0, 0, 0}));
  EXPECT_EQ(ComparedAfter(kX + 1, kY + kSlotRows + 1), (Blocks{0, 0, 0, 0, 0}));
}

// A slot that has a sample already is nearer to that one than to a second.
TEST(CompareSlots, ASampleThatChangesNoColorRenewsItsBlocksBestGain) {
  SlotPlane before;
  for (CellSlots& cell : before.cells) cell.distance2.fill(0);
  const std::vector<SeenSample> samples = {
      {SlotPlane::kColumns + 2, V2f(0.3f, 0.8f), Rgb(0), Rgb(0.5f)}};
  const auto at = static_cast<std::size_t>(before.grid.At(2, 1));
  ForEachSimdTarget([&] {
    SlotPlane plane = before;
    EnterSamples(samples, 0, SlotPlane::kRows - 1, plane.Slots());
    EXPECT_EQ(plane.cells[at].color, before.cells[at].color);
    EXPECT_NE(plane.cells[at].samples, before.cells[at].samples);
    std::vector<float> best = kOld;
    CompareSlots(plane.Slots(), 1, kLeast, false, best.data());
    SlotPlane expected = plane;
    PlainCompare(2, 1, false, expected);
    EXPECT_EQ(plane.gains[at * kBlocks + 1], expected.gains[at * kBlocks + 1]);
    EXPECT_EQ(plane.gains[at * kBlocks], -1.0f);
  });
}

}  // namespace
}  // namespace rtb
