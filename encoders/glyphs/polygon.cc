#include "encoders/glyphs/polygon.h"

#include <algorithm>
#include <cmath>

#include "core/math/vec.h"
#include "encoders/glyphs/shape.h"

namespace rtb {
namespace {

using Corners = std::vector<V2d>;

/// Cuts off what lies beyond `limit` along an axis (0 = x, 1 = y); with sign
/// -1 what lies before it. Sutherland and Hodgman, "Reentrant Polygon
/// Clipping", CACM 17(1), 1974. A polygon that falls apart stays joined by
/// edges along the limit, which have no area.
Corners Clip(const Corners& corners, int axis, double sign, double limit) {
  const auto inside = [&](const V2d& p) {
    return sign * (p[axis] - limit) <= 0;
  };
  Corners clipped;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const V2d& a = corners[i];
    const V2d& b = corners[(i + 1) % corners.size()];
    if (inside(a)) clipped.push_back(a);
    if (inside(a) == inside(b)) continue;
    const double t = (limit - a[axis]) / (b[axis] - a[axis]);
    V2d crossing = a + (b - a) * t;
    crossing[axis] = limit;
    clipped.push_back(crossing);
  }
  return clipped;
}

/// Gauss's area formula.
double Area(const Corners& corners) {
  double twice = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    twice += corners[i].cross(corners[(i + 1) % corners.size()]);
  }
  return std::abs(twice) / 2;
}

}  // namespace

double CoveredShare(const ShapePolygon& polygon, int x, int y, int width,
                    int height) {
  // In units of the sub-pixel, from its top left.
  Corners corners;
  for (const ShapePoint& point : polygon) {
    corners.emplace_back(
        static_cast<double>(point.x * width) / kShapeUnits - x,
        static_cast<double>(point.y * height) / kShapeUnits - y);
  }
  for (const int axis : {0, 1}) {
    corners = Clip(corners, axis, -1, 0);
    corners = Clip(corners, axis, 1, 1);
  }
  return std::min(1.0, Area(corners));
}

}  // namespace rtb
