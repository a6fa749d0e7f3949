/// @file
/// Masks of shapes, and how tests show them.
#pragma once

#include <string>

#include "encoders/glyphs/mask.h"

namespace rtb {

/// The mask of a glyph that must have a shape.
Mask MaskOf(char32_t glyph, int width, int height);

/// Rows ended by LF: '.' 0, '#' 1, else the coverage in tenths.
std::string Text(const Mask& mask);

}  // namespace rtb
