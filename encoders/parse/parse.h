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

/// What a terminal of the given size shows after `ansi` was written to it.
/// @return an Error when the text scrolls: it was made for a larger grid.
Result<CellGrid> ParseAnsi(const std::string& ansi, GridSize size);

}  // namespace rtb
