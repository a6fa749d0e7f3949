/// @file
/// How two grids of cells differ.
#pragma once

#include "core/base/result.h"
#include "encoders/cell_grid.h"

namespace rtb {

/// Counts over cells in canonical form.
struct CellDifference {
  int total = 0;   ///< Cells of one grid.
  int cells = 0;   ///< Cells that differ in anything.
  int glyphs = 0;  ///< Cells that differ in the glyph.
  int colors = 0;  ///< Cells that differ in a color.
};

/// @return kBadInput for grids of different sizes.
Result<CellDifference> CompareCells(const CellGrid& a, const CellGrid& b);

}  // namespace rtb
