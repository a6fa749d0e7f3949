#include "core/math/affine.h"

#include <cmath>
#include <numbers>

namespace rtb {
namespace {

/// Cosine and sine of an angle in degrees, exact at multiples of 90.
struct CosSin {
  double c, s;
};

CosSin OfDegrees(double degrees) {
  const double turn = std::fmod(degrees, 360.0);
  if (turn == 0) return {1, 0};
  if (turn == 90 || turn == -270) return {0, 1};
  if (turn == 180 || turn == -180) return {-1, 0};
  if (turn == 270 || turn == -90) return {0, -1};
  const double radians = turn * std::numbers::pi / 180;
  return {std::cos(radians), std::sin(radians)};
}

}  // namespace

Affined PositionRotateScale(const V3d& position, const V3d& degrees,
                            const V3d& scale) {
  const auto [cx, sx] = OfDegrees(degrees.x);
  const auto [cy, sy] = OfDegrees(degrees.y);
  const auto [cz, sz] = OfDegrees(degrees.z);
  Affined map;  // columns of Rz Ry Rx, each times its scale
  map.x = V3d(cz * cy, sz * cy, -sy) * scale.x;
  map.y =
      V3d(cz * sy * sx - sz * cx, sz * sy * sx + cz * cx, cy * sx) * scale.y;
  map.z =
      V3d(cz * sy * cx + sz * sx, sz * sy * cx - cz * sx, cy * cx) * scale.z;
  map.origin = position;
  return map;
}

Affinef ToFloat(const Affined& map) {
  return {V3f(map.x), V3f(map.y), V3f(map.z), V3f(map.origin)};
}

}  // namespace rtb
