#include <span>
#include <string>
#include <vector>

#include "encoders/emit/emit.h"
#include "encoders/emit/pen.h"

namespace rtb {
namespace {

void AppendRow(std::span<const Cell> cells, ColorDepth depth,
               std::string* text) {
  const std::vector<PenColors> wanted = WantedColors(cells);
  AnsiPen pen(depth);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    pen.Append(cells[i], wanted[i], text);
  }
  *text += pen.used() ? "\x1b[m\n" : "\n";
}

}  // namespace

std::string EmitAnsi(const CellGrid& grid, ColorDepth depth) {
  const std::span<const Cell> cells(grid.cells);
  const auto columns = static_cast<std::size_t>(grid.size.columns);
  std::string text;
  for (std::size_t row = 0; row * columns < cells.size(); ++row) {
    AppendRow(cells.subspan(row * columns, columns), depth, &text);
  }
  return text;
}

}  // namespace rtb
