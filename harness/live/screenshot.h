/// @file
/// Screenshots: the picture as PNG, ANSI text and JSON.
#pragma once

#include <string>

#include "core/base/result.h"
#include "encoders/cell_grid.h"
#include "encoders/color_depth.h"

namespace rtb {

/// Writes NAME.png (8 x 16 pixels a cell), NAME.ansi and NAME.json into the
/// current folder; no file is overwritten.
/// @return NAME.
Result<std::string> WriteScreenshot(const CellGrid& picture, ColorDepth depth);

}  // namespace rtb
