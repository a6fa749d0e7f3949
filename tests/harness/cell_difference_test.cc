#include "harness/cell_difference.h"

#include <gtest/gtest.h>

namespace rtb {
namespace {

constexpr Rgb8 kRed{255, 0, 0};
constexpr Rgb8 kBlue{0, 0, 255};

CellGrid Row(std::vector<Cell> cells) {
  CellGrid grid;
  grid.size = {static_cast<int>(cells.size()), 1};
  grid.cells = std::move(cells);
  return grid;
}

// What nobody sees - a space's foreground, a full block's background, the kind
// of space - does not count.
TEST(CompareCells, LooksAtTheCanonicalForm) {
  const CellGrid a = Row({{U' ', kRed, kBlue}, {U'█', kRed, kBlue}});
  const CellGrid b = Row({{U'\u00A0', kBlue, kBlue}, {U'█', kRed, kRed}});
  EXPECT_EQ(CompareCells(a, b)->cells, 0);
}

TEST(CompareCells, CountsGlyphsAndColorsApart) {
  const CellGrid a = Row({{U'▄', kRed, kBlue},
                          {U'▄', kRed, kBlue},
                          {U'▄', kRed, kBlue},
                          {U'▄', kRed, kBlue}});
  const CellGrid b = Row({{U'▄', kRed, kBlue},
                          {U'▀', kRed, kBlue},
                          {U'▄', kBlue, kBlue},
                          {U'▀', kBlue, kRed}});
  const CellDifference difference = CompareCells(a, b).value();
  EXPECT_EQ(difference.total, 4);
  EXPECT_EQ(difference.cells, 3);
  EXPECT_EQ(difference.glyphs, 2);
  EXPECT_EQ(difference.colors, 2);
}

TEST(CompareCells, RefusesGridsOfOtherSizes) {
  const auto difference = CompareCells(CellGrid({2, 3}), CellGrid({3, 2}));
  ASSERT_FALSE(difference.has_value());
  EXPECT_EQ(difference.error().kind, ErrorKind::kBadInput);
}

}  // namespace
}  // namespace rtb
