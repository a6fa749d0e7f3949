#include "harness/live/text.h"

#include <algorithm>

#include "encoders/parse/glyph_text.h"
#include "harness/results/display_width.h"

namespace rtb {
namespace {

/// Bytes of the character that begins so, as far as its first byte tells.
std::size_t LengthOf(char first) {
  const auto byte = static_cast<unsigned char>(first);
  return byte < 0xC0 ? 1 : byte < 0xE0 ? 2 : byte < 0xF0 ? 3 : 4;
}

Cell* CellAt(int column, int row, CellGrid* grid) {
  const bool inside = column >= 0 && column < grid->size.columns && row >= 0 &&
                      row < grid->size.rows;
  return inside ? &grid->at(column, row) : nullptr;
}

}  // namespace

std::u32string Glyphs(std::string_view utf8) {
  std::u32string glyphs;
  while (!utf8.empty()) {
    const std::size_t length = std::min(LengthOf(utf8[0]), utf8.size());
    const auto glyph = ParseGlyph(utf8.substr(0, length));
    const bool fits = glyph && DisplayWidth(utf8.substr(0, length)) == 1;
    glyphs += fits ? *glyph : U'?';
    utf8.remove_prefix(glyph ? length : 1);
  }
  return glyphs;
}

void FillRect(const CellRect& rect, Rgb8 color, CellGrid* grid) {
  for (int row = rect.row; row < rect.row + rect.rows; ++row) {
    for (int column = rect.column; column < rect.column + rect.columns;
         ++column) {
      if (Cell* cell = CellAt(column, row, grid)) *cell = {U' ', color, color};
    }
  }
}

void DrawText(const CellRect& rect, int column, int row,
              std::u32string_view text, const TextColors& colors,
              CellGrid* grid) {
  if (row < 0 || row >= rect.rows) return;
  for (const char32_t glyph : text) {
    if (column >= rect.columns) return;
    Cell* cell = CellAt(rect.column + column++, rect.row + row, grid);
    if (cell != nullptr) *cell = {glyph, colors.fg, colors.bg};
  }
}

}  // namespace rtb
