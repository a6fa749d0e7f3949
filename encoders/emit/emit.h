/// @file
/// A CellGrid as text or picture.
#pragma once

#include <string>

#include "core/base/result.h"
#include "encoders/cell_grid.h"

namespace rtb {

/// ANSI text with 24-bit colors: changed attributes only, reset at each
/// line's end, UTF-8, LF after each row.
std::string EmitAnsi(const CellGrid& grid);

/// `{"columns": C, "rows": R, "cells": [[glyph, "#rrggbb", "#rrggbb"], ...]}`.
std::string EmitJson(const CellGrid& grid);

/// A self-contained SVG of cell_width x cell_height pixels a cell; glyphs
/// with a geometric definition are drawn as exact shapes, others as text.
std::string EmitSvg(const CellGrid& grid, int cell_width, int cell_height);

/// UTF-8 of one code point.
std::string Utf8(char32_t code_point);

}  // namespace rtb
