/// @file
/// A grid of random slots, to try the loops of slot_kernels.h on.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/math/random.h"
#include "encoders/adaptive/slot_kernels.h"

namespace rtb {

inline constexpr float kLeast = 1e-6f;

inline float Unit(std::size_t index, std::uint32_t dimension) {
  return UnitFloat(
      RandomBits(static_cast<std::uint32_t>(index), dimension, 0, 9));
}

/// A grid of random slots.
struct SlotPlane {
  static constexpr int kColumns = 5, kRows = 4;

  explicit SlotPlane(float cell_width = 8) {
    grid.grid = {kColumns, kRows};
    grid.cell_width = cell_width;
    cells.resize(grid.room());
    changed.resize(grid.room());
    around.resize(grid.room() * kBlocks, kFar2);
    gains.resize(around.size(), -1.0f);
    farthest.resize(around.size());
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
      for (std::size_t i = 0; i < kSlots; ++i) {
        const std::size_t place = cell * kSlots + i;
        cells[cell].distance2[i] = 30 * Unit(place, 0);
        cells[cell].color[i] =
            PackedColor(Rgb(Unit(place, 1), Unit(place, 2), Unit(place, 3)));
        cells[cell].contrast[i] = Unit(place, 4);
        cells[cell].samples[i] = Unit(place, 5) < 0.5f ? 0 : 1;
      }
    }
    for (int row = 0; row < kRows; ++row) {
      for (int column = 0; column < kColumns; ++column) Bound(column, row);
    }
  }

  /// A cell's `farthest`.
  void Bound(int column, int row) {
    const auto cell = static_cast<std::size_t>(grid.At(column, row));
    const float* const distances = cells[cell].distance2.data();
    for (std::size_t block = 0; block < kBlocks; ++block) {
      const float* const from = distances + block * kBlockSlots;
      farthest[cell * kBlocks + block] =
          *std::max_element(from, from + kBlockSlots);
    }
  }

  SlotGrid Slots() {
    grid.cells = cells.data();
    grid.changed = changed.data();
    grid.farthest = farthest.data();
    grid.around = around.data();
    grid.gains = gains.data();
    return grid;
  }

  /// By columns and rows of slots; up to a whole cell outside.
  std::size_t Cell(int x, int y) const {
    return static_cast<std::size_t>(
        grid.At((x + kSlotColumns) / kSlotColumns - 1,
                (y + kSlotRows) / kSlotRows - 1));
  }
  static std::size_t InCell(int x, int y) {
    return static_cast<std::size_t>((y + kSlotRows) % kSlotRows * kSlotColumns +
                                    (x + kSlotColumns) % kSlotColumns);
  }
  std::uint32_t Color(int x, int y) const {
    return cells[Cell(x, y)].color[InCell(x, y)];
  }

  SlotGrid grid;
  std::vector<CellSlots> cells;
  std::vector<std::uint32_t> changed;
  std::vector<float> farthest, around, gains;
};

inline void ExpectSame(const SlotPlane& a, const SlotPlane& b) {
  for (std::size_t i = 0; i < a.cells.size(); ++i) {
    EXPECT_EQ(a.cells[i].distance2, b.cells[i].distance2) << i;
    EXPECT_EQ(a.cells[i].color, b.cells[i].color) << i;
    EXPECT_EQ(a.cells[i].contrast, b.cells[i].contrast) << i;
    EXPECT_EQ(a.cells[i].samples, b.cells[i].samples) << i;
  }
  EXPECT_EQ(a.changed, b.changed);
  EXPECT_EQ(a.farthest, b.farthest);
  EXPECT_EQ(a.gains, b.gains);
}

}  // namespace rtb
