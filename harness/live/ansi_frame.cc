#include "harness/live/ansi_frame.h"

#include <vector>

#include "encoders/emit/pen.h"

namespace rtb {

std::string AnsiFrame(const CellGrid& screen, std::span<const int> changed,
                      ColorDepth depth) {
  std::vector<Cell> cells;
  cells.reserve(changed.size());
  for (const int index : changed) {
    cells.push_back(screen.cells[static_cast<std::size_t>(index)]);
  }
  const std::vector<PenColors> wanted = WantedColors(cells);
  constexpr std::size_t kBytesPerCell = 40;
  std::string text;
  text.reserve(cells.size() * kBytesPerCell);
  AnsiPen pen(depth);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const int column = changed[i] % screen.size.columns;
    const bool follows = i > 0 && changed[i - 1] + 1 == changed[i];
    if (!follows || column == 0) {
      text += "\x1b[" + std::to_string(changed[i] / screen.size.columns + 1) +
              ';' + std::to_string(column + 1) + 'H';
    }
    pen.Append(cells[i], wanted[i], &text);
  }
  return text;
}

}  // namespace rtb
