/// @file
/// Polygons in a cell, and how much of a rectangle they cover.
#pragma once

#include <vector>

namespace rtb {

/// A point in 72nds (kShapeUnits) of the cell's width and height, y down.
struct ShapePoint {
  int x, y;
  bool operator==(const ShapePoint&) const = default;
};

/// Corners in either direction; no edge crosses another one.
using ShapePolygon = std::vector<ShapePoint>;

/// Share of the sub-pixel in column x and row y of width x height that the
/// polygon covers: the exact area, in double precision.
double CoveredShare(const ShapePolygon& polygon, int x, int y, int width,
                    int height);

}  // namespace rtb
