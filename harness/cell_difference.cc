#include "harness/cell_difference.h"

#include <string>

namespace rtb {
namespace {

std::string Text(GridSize size) {
  return std::to_string(size.columns) + "x" + std::to_string(size.rows);
}

}  // namespace

Result<CellDifference> CompareCells(const CellGrid& a, const CellGrid& b) {
  if (a.size != b.size) {
    return Fail(BadInput("--against", "found a grid of " + Text(b.size) +
                                          " cells, expected " + Text(a.size)));
  }
  CellDifference difference;
  difference.total = a.size.cells();
  for (std::size_t i = 0; i < a.cells.size(); ++i) {
    const Cell p = Canonical(a.cells[i]);
    const Cell q = Canonical(b.cells[i]);
    difference.cells += p == q ? 0 : 1;
    difference.glyphs += p.glyph == q.glyph ? 0 : 1;
    difference.colors += p.fg == q.fg && p.bg == q.bg ? 0 : 1;
  }
  return difference;
}

}  // namespace rtb
