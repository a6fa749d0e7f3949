#include <gtest/gtest.h>

#include "encoders/cell_grid.h"
#include "tests/encoders/testing.h"

namespace rtb {
namespace {

constexpr Rgb8 kRed{255, 0, 0};
constexpr Rgb8 kBlue{0, 0, 255};

TEST(CanonicalTest, HidesWhatNobodySees) {
  EXPECT_EQ(Canonical(Cell{U' ', kRed, kBlue}), (Cell{U' ', {}, kBlue}));
  EXPECT_EQ(Canonical(Cell{U'\u00A0', kRed, kBlue}), (Cell{U' ', {}, kBlue}));
  EXPECT_EQ(Canonical(Cell{U'█', kRed, kBlue}), (Cell{U'█', kRed, {}}));
}

TEST(CanonicalTest, KeepsEverythingElse) {
  const Cell cell{U'▄', kRed, kBlue};
  EXPECT_EQ(Canonical(cell), cell);
}

TEST(CanonicalTest, AppliesToEveryCellOfAGrid) {
  CellGrid grid({2, 1});
  grid.at(0, 0) = {U'\u00A0', kRed, kBlue};
  grid.at(1, 0) = {U'█', kRed, kBlue};
  const CellGrid canonical = Canonical(grid);
  EXPECT_EQ(canonical.at(0, 0), (Cell{U' ', {}, kBlue}));
  EXPECT_EQ(canonical.at(1, 0), (Cell{U'█', kRed, {}}));
}

}  // namespace
}  // namespace rtb
