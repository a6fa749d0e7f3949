#include "encoders/glyphs/wedges.h"

#include <algorithm>
#include <array>

#include "encoders/glyphs/shape.h"

namespace rtb {
namespace {

constexpr int kAll = kShapeUnits;
constexpr int kHalf = kShapeUnits / 2;
constexpr int kThird = kShapeUnits / 3;

/// The points of the cell's border between which wedges are cut, clockwise.
enum BorderPoint {
  kUpperLeft,
  kUpperCenter,
  kUpperRight,
  kUpperMiddleRight,
  kLowerMiddleRight,
  kLowerRight,
  kLowerCenter,
  kLowerLeft,
  kLowerMiddleLeft,
  kUpperMiddleLeft,
  kBorderPoints
};

constexpr std::array<ShapePoint, kBorderPoints> kPlaces = {{{0, 0},
                                                            {kHalf, 0},
                                                            {kAll, 0},
                                                            {kAll, kThird},
                                                            {kAll, 2 * kThird},
                                                            {kAll, kAll},
                                                            {kHalf, kAll},
                                                            {0, kAll},
                                                            {0, 2 * kThird},
                                                            {0, kThird}}};

/// A block that holds one corner, cut off from `begin` to `end`.
struct Wedge {
  char32_t glyph;
  BorderPoint corner;
  BorderPoint begin;
  BorderPoint end;
};

constexpr Wedge kWedges[] = {
#include "encoders/glyphs/wedge_table.inc"
};

bool IsCorner(int point) {
  return point == kUpperLeft || point == kUpperRight || point == kLowerRight ||
         point == kLowerLeft;
}

/// Clockwise along the border from one point to another, with the corners in
/// between.
ShapePolygon AlongBorder(int begin, int end) {
  ShapePolygon polygon = {kPlaces[static_cast<std::size_t>(begin)]};
  for (int i = (begin + 1) % kBorderPoints; i != end;
       i = (i + 1) % kBorderPoints) {
    if (IsCorner(i)) polygon.push_back(kPlaces[static_cast<std::size_t>(i)]);
  }
  polygon.push_back(kPlaces[static_cast<std::size_t>(end)]);
  return polygon;
}

/// The border on the side of the named corner, closed by the diagonal.
ShapePolygon OutlineOf(const Wedge& wedge) {
  const ShapePolygon side = AlongBorder(wedge.begin, wedge.end);
  const ShapePoint& corner = kPlaces[wedge.corner];
  if (std::ranges::find(side, corner) != side.end()) return side;
  return AlongBorder(wedge.end, wedge.begin);
}

/// U+1FB68-1FB6B leave out the quarter on the left, above, on the right or
/// below; U+1FB6C-1FB6F are these quarters.
ShapePolygon TriangleOf(char32_t glyph) {
  constexpr ShapePoint kCenter = {kHalf, kHalf};
  // The corners of the quarters on their clockwise way round the cell.
  constexpr BorderPoint kCorners[] = {kLowerLeft, kUpperLeft, kUpperRight,
                                      kLowerRight, kLowerLeft};
  const bool quarter = glyph >= 0x1FB6C;
  const auto side = static_cast<std::size_t>(glyph & 3);
  const BorderPoint begin = kCorners[side];
  const BorderPoint end = kCorners[side + 1];
  ShapePolygon polygon =
      quarter ? AlongBorder(begin, end) : AlongBorder(end, begin);
  polygon.push_back(kCenter);
  return polygon;
}

}  // namespace

std::optional<ShapePolygon> WedgeOf(char32_t glyph) {
  if (glyph >= 0x1FB68 && glyph <= 0x1FB6F) return TriangleOf(glyph);
  const auto found = std::ranges::find(kWedges, glyph, &Wedge::glyph);
  if (found == std::end(kWedges)) return std::nullopt;
  return OutlineOf(*found);
}

}  // namespace rtb
