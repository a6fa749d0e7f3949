/// @file
/// CellGrid: a picture made of cells.
#pragma once

#include <vector>

#include "core/render/sample_plan.h"
#include "encoders/cell.h"

namespace rtb {

/// columns x rows cells, row by row from the top left.
struct CellGrid {
  GridSize size;
  std::vector<Cell> cells;

  CellGrid() = default;
  explicit CellGrid(GridSize grid)
      : size(grid), cells(static_cast<std::size_t>(grid.cells())) {}

  Cell& at(int column, int row) {
    return cells[static_cast<std::size_t>(row * size.columns + column)];
  }
  const Cell& at(int column, int row) const {
    return cells[static_cast<std::size_t>(row * size.columns + column)];
  }
  bool operator==(const CellGrid&) const = default;
};

/// Every cell in canonical form.
CellGrid Canonical(CellGrid grid);

}  // namespace rtb
