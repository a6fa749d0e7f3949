/// @file
/// The wedges and triangles of Unicode 13 (U+1FB3C-1FB6F).
#pragma once

#include <optional>

#include "encoders/glyphs/polygon.h"

namespace rtb {

/// The outline of a wedge or triangle, if the glyph is one.
std::optional<ShapePolygon> WedgeOf(char32_t glyph);

}  // namespace rtb
