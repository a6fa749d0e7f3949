#include "encoders/glyphs/mask.h"

#include <algorithm>

namespace rtb {
namespace {

/// Length that [begin, end), in units of the cell, shares with sub-pixel
/// `index` of `count`, in units of the sub-pixel: a whole number, since a cell
/// is kShapeUnits * count of these long.
int Overlap(int begin, int end, int index, int count) {
  const int low = std::max(begin * count, index * kShapeUnits);
  const int high = std::min(end * count, (index + 1) * kShapeUnits);
  return std::max(0, high - low);
}

int CoveredArea(const GlyphShape& shape, int x, int y, const Mask& mask) {
  int area = 0;
  for (const ShapeRect& rect : shape.rects) {
    area += Overlap(rect.left, rect.right, x, mask.width) *
            Overlap(rect.top, rect.bottom, y, mask.height);
  }
  return area;
}

/// Share of a sub-pixel inside the shape's outlines.
double CoverageAt(const GlyphShape& shape, int x, int y, const Mask& mask) {
  constexpr int kFull = kShapeUnits * kShapeUnits;
  double covered = static_cast<double>(CoveredArea(shape, x, y, mask)) / kFull;
  for (const ShapePolygon& polygon : shape.polygons) {
    covered += CoveredShare(polygon, x, y, mask.width, mask.height);
  }
  return covered;
}

}  // namespace

Mask RasterizeShape(const GlyphShape& shape, int width, int height) {
  Mask mask(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double covered = shape.quarters * CoverageAt(shape, x, y, mask) / 4;
      mask.at(x, y) = static_cast<float>(covered);
    }
  }
  return mask;
}

}  // namespace rtb
