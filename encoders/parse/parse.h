/// @file
/// Grids from text: our own JSON, and any program's ANSI through libvterm.
#pragma once

#include <string>

#include "core/base/result.h"
#include "encoders/cell_grid.h"

namespace rtb {

/// Reads what EmitJson writes. @param name names the text in errors.
Result<CellGrid> ParseCellsJson(const std::string& text,
                                const std::string& name);

/// What a terminal of the given size shows after `ansi` was written to it: the
/// first character of each cell in the colors that it is drawn in. Reversed
/// colors are swapped, concealed characters are spaces, faint ones have two
/// thirds of their color; bold, blinking and lines do not count. Where no color
/// was set stand those of encoders/palette.h. docs/terminals.md has it all.
/// @return kBadInput when the text scrolls, because it was made for a larger
///   grid, and when it holds graphics.
Result<CellGrid> ParseAnsi(const std::string& ansi, GridSize size);

}  // namespace rtb
