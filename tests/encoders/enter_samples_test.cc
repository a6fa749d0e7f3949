// Every vector instruction set enters what plain loops over the slots do, bit
// for bit.
#include <gtest/gtest.h>

#include "tests/encoders/slot_plane.h"
#include "tests/simd_targets.h"

namespace rtb {
namespace {

/// Three samples in each cell.
std::vector<SeenSample> Samples() {
  std::vector<SeenSample> samples;
  for (int i = 0; i < 3 * SlotPlane::kColumns * SlotPlane::kRows; ++i) {
    const auto place = static_cast<std::size_t>(i);
    samples.push_back({i / 3, V2f(Unit(place, 10), Unit(place, 11)), Rgb(0),
                       Rgb(Unit(place, 12), Unit(place, 13), Unit(place, 14))});
  }
  return samples;
}

/// @param x,y of the block, by columns and rows of blocks.
void PlainEnterBlock(const SeenSample& sample, const V2f& place, int x, int y,
                     SlotPlane& plane) {
  const auto cell = static_cast<std::size_t>(plane.grid.At(x, y / kBlocks));
  for (int i = 0; i < kBlockSlots; ++i) {
    const auto column = static_cast<float>(i % kSlotColumns) + 0.5f;
    const auto row = static_cast<float>(i / kSlotColumns) + 0.5f;
    const float dx = column * (plane.grid.cell_width / kSlotColumns) - place.x;
    const float dy = row * (kCellHeight / kSlotRows) - place.y;
    const auto slot = static_cast<std::size_t>(y % kBlocks * kBlockSlots + i);
    float& distance2 = plane.cells[cell].distance2[slot];
    if (dx * dx + dy * dy >= distance2) continue;
    distance2 = dx * dx + dy * dy;
    plane.cells[cell].color[slot] = PackedColor(sample.encoded);
    plane.changed[cell] |= 1u << slot;
  }
}

void PlainEnter(const SeenSample& sample, int first, int last,
                SlotPlane& plane) {
  const int column = sample.cell % SlotPlane::kColumns;
  const int row = sample.cell / SlotPlane::kColumns;
  const int half = sample.position.y < 0.5f ? 0 : 1;
  const float x = sample.position.x * plane.grid.cell_width;
  const float y =
      sample.position.y * kCellHeight - static_cast<float>(half) * kBlockHeight;
  for (int j = -1; j <= 1; ++j) {
    const int block = row * kBlocks + half + j;
    if (block < first * kBlocks || block >= (last + 1) * kBlocks) continue;
    for (int i = -1; i <= 1; ++i) {
      if (column + i < 0 || column + i >= SlotPlane::kColumns) continue;
      PlainEnterBlock(sample,
                      V2f(x - static_cast<float>(i) * plane.grid.cell_width,
                          y - static_cast<float>(j) * kBlockHeight),
                      column + i, block, plane);
    }
  }
  if (row < first || row > last) return;
  const auto cell = static_cast<std::size_t>(plane.grid.At(column, row));
  const std::size_t slot = SlotAt(sample.position);
  ++plane.cells[cell].samples[slot];
  plane.changed[cell] |= 1u << slot;
}

/// @param width of the cells.
void ExpectPlainSlots(float width, int first, int last) {
  const std::vector<SeenSample> samples = Samples();
  SlotPlane expected(width);
  for (const SeenSample& sample : samples) {
    PlainEnter(sample, first, last, expected);
  }
  ASSERT_NE(expected.changed, SlotPlane().changed);
  ForEachSimdTarget([&] {
    SlotPlane plane(width);
    EnterSamples(samples, first, last, plane.Slots());
    ExpectSame(plane, expected);
  });
}

TEST(EnterSamples, EntersIntoRowsAndNowhereElse) {
  for (const float width : {4.0f, 8.0f, 16.0f}) {
    for (const int first : {0, 1, 3}) {
      for (int last = first; last < SlotPlane::kRows; ++last) {
        ExpectPlainSlots(width, first, last);
      }
    }
  }
}

// Blocks on the far sides of a sample's are half a block away at least.
TEST(EnterSamples, EntersIntoBlocksOnTheNearSidesWhereThatIsEnough) {
  SlotPlane near;
  for (CellSlots& cell : near.cells) {
    for (float& distance2 : cell.distance2) distance2 *= 25.0f / 30;
  }
  for (int row = 0; row < SlotPlane::kRows; ++row) {
    for (int column = 0; column < SlotPlane::kColumns; ++column) {
      near.Bound(column, row);
    }
  }
  SlotPlane expected = near;
  for (const SeenSample& sample : Samples()) {
    PlainEnter(sample, 0, SlotPlane::kRows - 1, expected);
  }
  ForEachSimdTarget([&] {
    SlotPlane plane = near;
    std::ranges::fill(plane.around, 25.0f);
    EnterSamples(Samples(), 0, SlotPlane::kRows - 1, plane.Slots());
    ExpectSame(plane, expected);
  });
}

}  // namespace
}  // namespace rtb
