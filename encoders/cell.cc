#include "encoders/cell.h"

#include "encoders/cell_grid.h"

namespace rtb {

Cell Canonical(Cell cell) {
  if (cell.glyph == kNoBreakSpace) cell.glyph = U' ';
  if (cell.glyph == U' ') cell.fg = Rgb8{};
  if (cell.glyph == kFullBlock) cell.bg = Rgb8{};
  return cell;
}

CellGrid Canonical(CellGrid grid) {
  for (Cell& cell : grid.cells) cell = Canonical(cell);
  return grid;
}

}  // namespace rtb
