#include "harness/live/screen_diff.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rtb {
namespace {

constexpr Rgb8 kRed{200, 0, 0};
constexpr Rgb8 kBlue{0, 0, 200};

CellGrid Uniform(const Cell& cell, GridSize size = {10, 4}) {
  CellGrid grid(size);
  std::ranges::fill(grid.cells, cell);
  return grid;
}

TEST(Appearance, DependsOnWhatIsSeenAlone) {
  AppearanceTable table;
  EXPECT_EQ(table.Difference({U' ', kRed, kBlue}, {U' ', kBlue, kBlue}), 0);
  EXPECT_EQ(table.Difference({U'█', kBlue, kRed}, {U' ', kRed, kBlue}), 0);
  // The complement in swapped colors.
  EXPECT_EQ(table.Difference({U'▀', kRed, kBlue}, {U'▄', kBlue, kRed}), 0);
  EXPECT_EQ(table.Difference({U'▚', kRed, kBlue}, {U'▞', kBlue, kRed}), 0);
}

TEST(Appearance, IsTheRmsOfEightBitValues) {
  AppearanceTable table;
  // One of three channels differs by 30 everywhere: 30 / sqrt(3).
  EXPECT_NEAR(table.Difference({U'█', {30, 0, 0}, {}}, {U'█', {0, 0, 0}, {}}),
              30 / std::sqrt(3.0), 1e-4);
  // In half of the cell: 30 / sqrt(6).
  EXPECT_NEAR(table.Difference({U'▀', {30, 0, 0}, {}}, {U' ', {}, {}}),
              30 / std::sqrt(6.0), 1e-4);
}

TEST(Appearance, CharactersAreNeverAlike) {
  AppearanceTable table;
  EXPECT_TRUE(
      std::isinf(table.Difference({U'a', kRed, kRed}, {U'b', kRed, kRed})));
  EXPECT_EQ(table.Difference({U'a', kRed, kBlue}, {U'a', kRed, kBlue}), 0);
}

TEST(ScreenDiff, SendsAllFirstAndNothingThen) {
  ScreenDiff diff;
  const CellGrid grid = Uniform({U'▀', kRed, kBlue});
  EXPECT_EQ(diff.Select(grid, {}).size(), 40u);
  EXPECT_TRUE(diff.cleared());
  EXPECT_EQ(diff.Select(grid, {}).size(), 0u);
  EXPECT_FALSE(diff.cleared());
  diff.Invalidate();
  EXPECT_EQ(diff.Select(grid, {}).size(), 40u);
  EXPECT_EQ(diff.Select(Uniform({}, {3, 3}), {}).size(), 9u);
  EXPECT_TRUE(diff.cleared());
}

TEST(ScreenDiff, WhatIsWithinTheThresholdWaitsButNotForEver) {
  ScreenDiff diff;
  diff.Select(Uniform({U'█', {100, 0, 0}, {}}), {});
  const CellGrid wanted = Uniform({U'█', {103, 0, 0}, {}});  // RMS 1.7.
  int frames = 1;
  while (diff.Select(wanted, {.threshold = 6, .oldest = 20}).empty()) {
    EXPECT_FALSE(diff.exact());
    ASSERT_LE(++frames, 20);
  }
  EXPECT_EQ(frames, 20);
  EXPECT_TRUE(diff.exact());
  EXPECT_EQ(diff.shown(), wanted);
}

TEST(ScreenDiff, TheLargestDifferencesComeFirst) {
  ScreenDiff diff;
  CellGrid grid = Uniform({U'█', {0, 0, 0}, {}});
  diff.Select(grid, {});
  grid.cells[7].fg = {10, 0, 0};
  grid.cells[3].fg = {200, 0, 0};
  grid.cells[5].fg = {100, 0, 0};
  EXPECT_EQ(diff.Select(grid, {.threshold = 0, .budget = 2}),
            (std::vector<int>{3, 5}));
  EXPECT_FALSE(diff.exact());
  EXPECT_EQ(diff.Select(grid, {.threshold = 0, .budget = 2}),
            std::vector<int>{7});
  EXPECT_TRUE(diff.exact());
}

TEST(ScreenDiff, NoCellStarvesUnderABudget) {
  ScreenDiff diff;
  CellGrid grid = Uniform({U'█', {0, 0, 0}, {}});
  diff.Select(grid, {});
  grid.cells[20].fg = {8, 0, 0};
  bool sent = false;
  for (int frame = 0; frame < 60 && !sent; ++frame) {
    // Another cell changes by much more in every frame.
    grid.cells[0].fg.r = static_cast<std::uint8_t>(frame % 2 == 0 ? 200 : 0);
    const auto cells = diff.Select(grid, {.threshold = 0, .budget = 1});
    sent = std::ranges::count(cells, 20) > 0;
  }
  EXPECT_TRUE(sent);
}

// Noise flips glyphs of nearly equal look: what is told by glyph and colors
// changes everywhere, what is seen nearly nowhere.
TEST(ScreenDiff, NoiseCostsAtLeastTenTimesFewerCells) {
  const GridSize size{40, 20};
  ScreenDiff diff;
  CellGrid grid = Uniform({U'▀', {100, 90, 80}, {100, 90, 80}}, size);
  diff.Select(grid, {});
  unsigned state = 1;
  const auto noise = [&state](int spread) {
    state = state * 1664525 + 1013904223;
    return static_cast<int>(state >> 16) % (2 * spread + 1) - spread;
  };
  constexpr char32_t kGlyphs[] = {U'▀', U'▄', U'▌', U'▚', U'▞', U'▙'};
  std::size_t told = 0, sent = 0;
  for (int frame = 0; frame < 60; ++frame) {
    const CellGrid before = grid;
    for (Cell& cell : grid.cells) {
      cell.glyph = kGlyphs[static_cast<unsigned>(noise(100) + 100) % 6];
      cell.fg = {static_cast<std::uint8_t>(100 + noise(3)), 90, 80};
      cell.bg = {static_cast<std::uint8_t>(100 + noise(3)), 90, 80};
    }
    for (std::size_t i = 0; i < grid.cells.size(); ++i) {
      told += Canonical(before.cells[i]) != Canonical(grid.cells[i]) ? 1 : 0;
    }
    sent += diff.Select(grid, {.threshold = 6}).size();
  }
  EXPECT_GT(sent, 0u);
  EXPECT_LE(10 * sent, told);
}

}  // namespace
}  // namespace rtb
