/// @file
/// The text that brings chosen cells of a screen up to date.
#pragma once

#include <span>
#include <string>

#include "encoders/cell_grid.h"
#include "encoders/color_depth.h"

namespace rtb {

/// Moves the cursor to each run of neighboring cells (absolutely: terminals
/// do not agree on how wide every glyph is) and writes it. Every color is
/// told anew, so that nothing is assumed of the terminal's state.
/// @param changed indices of cells, rising.
std::string AnsiFrame(const CellGrid& screen, std::span<const int> changed,
                      ColorDepth depth);

}  // namespace rtb
