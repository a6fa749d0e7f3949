/// @file
/// The exact outlines of glyphs that Unicode defines by their geometry.
#pragma once

#include <optional>
#include <vector>

#include "encoders/glyphs/polygon.h"

namespace rtb {

/// Coordinates of shapes count 72nds of the cell: eighths, sixths and ninths
/// are whole numbers, so that areas are exact.
inline constexpr int kShapeUnits = 72;

/// A rectangle in 72nds of the cell's width and height, y down.
struct ShapeRect {
  int left, top, right, bottom;
  bool operator==(const ShapeRect&) const = default;
};

/// Disjoint rectangles and polygons, all covered to the same share.
struct GlyphShape {
  std::vector<ShapeRect> rects;
  std::vector<ShapePolygon> polygons;  ///< What rectangles cannot make up.
  int quarters = 4;  ///< Coverage in quarters; less than 4 for shades.
};

/// The outline of a glyph that Unicode defines as a part of the cell: spaces,
/// block elements (U+2580-259F; the shades cover 1/4, 1/2 and 3/4 evenly),
/// sextants, octants and the blocks that complete them, wedges and triangles
/// (U+1FB3C-1FB6F). Also the horizontal
/// scan lines U+23BA-23BD, which fonts mostly lack: line n of 9 fills the n-th
/// ninth of the height.
std::optional<GlyphShape> ShapeOf(char32_t glyph);

}  // namespace rtb
