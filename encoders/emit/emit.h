/// @file
/// A CellGrid as text or picture.
#pragma once

#include <string>

#include "core/base/result.h"
#include "encoders/cell_grid.h"
#include "encoders/color_depth.h"

namespace rtb {

/// Text that draws the grid on a terminal: UTF-8, LF after each row, colors as
/// SGR 38;2 and 48;2 (kTruecolor), 38;5 and 48;5 with indices from 16 on
/// (k256), 30-37, 90-97, 40-47 and 100-107 (k16), or none (kMono). Only what a
/// glyph shows and what has changed is named, in one sequence a cell at most;
/// rows that set a color end with a reset.
/// @param depth the grid's colors are PaletteColors(depth); those of kMono are
///   left out, whatever they are.
std::string EmitAnsi(const CellGrid& grid,
                     ColorDepth depth = ColorDepth::kTruecolor);

/// `{"columns": C, "rows": R, "cells": [[glyph, "#rrggbb", "#rrggbb"], ...]}`.
std::string EmitJson(const CellGrid& grid);

/// A self-contained SVG of cell_width x cell_height pixels a cell; glyphs
/// with a geometric definition are drawn as exact shapes, others as text.
std::string EmitSvg(const CellGrid& grid, int cell_width, int cell_height);

/// UTF-8 of one code point.
std::string Utf8(char32_t code_point);

}  // namespace rtb
