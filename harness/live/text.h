/// @file
/// Text in a grid of cells.
#pragma once

#include <string>
#include <string_view>

#include "encoders/cell_grid.h"

namespace rtb {

/// A rectangle of cells.
struct CellRect {
  int column = 0;
  int row = 0;
  int columns = 0;
  int rows = 0;
};

/// Two colors of text.
struct TextColors {
  Rgb8 fg;
  Rgb8 bg;
};

/// UTF-8 as glyphs of one column each: what is none, control characters above
/// all, becomes a question mark.
std::u32string Glyphs(std::string_view utf8);

/// Makes all cells of a rectangle spaces; what is outside of the grid is cut.
void FillRect(const CellRect& rect, Rgb8 color, CellGrid* grid);

/// Writes into row `row` of a rectangle, cut at its border.
void DrawText(const CellRect& rect, int column, int row,
              std::u32string_view text, const TextColors& colors,
              CellGrid* grid);

}  // namespace rtb
