#include "core/color/cielab.h"

#include <cmath>

namespace rtb {
namespace {

/// A 3 x 3 matrix by rows.
struct Matrix {
  V3d x, y, z;

  V3d operator*(const V3d& v) const { return {x.dot(v), y.dot(v), z.dot(v)}; }
};

/// BT.709 primaries with D65 at (0.3127, 0.329), as exact fractions: Andersson
/// et al., "FLIP: A Difference Evaluator for Alternating Images", HPG 2020,
/// supplemental code.
const Matrix& ToXyz() {
  static const Matrix matrix = {
      {10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
      {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
      {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}};
  return matrix;
}

/// The inverse: its columns are cross products of the rows, over the
/// determinant.
Matrix Inverse(const Matrix& m) {
  const V3d a = m.y.cross(m.z);
  const V3d b = m.z.cross(m.x);
  const V3d c = m.x.cross(m.y);
  const double scale = 1 / m.x.dot(a);
  return {scale * V3d(a.x, b.x, c.x), scale * V3d(a.y, b.y, c.y),
          scale * V3d(a.z, b.z, c.z)};
}

/// CIE 15:2004, section 8.2.1.1.
double LabCurve(double t) {
  constexpr double kDelta = 6.0 / 29;
  if (t > kDelta * kDelta * kDelta) return std::cbrt(t);
  return t / (3 * kDelta * kDelta) + 4.0 / 29;
}

}  // namespace

V3d LinearToXyz(const V3d& linear) { return ToXyz() * linear; }

V3d XyzToLinear(const V3d& xyz) {
  static const Matrix matrix = Inverse(ToXyz());
  return matrix * xyz;
}

V3d XyzToLab(const V3d& xyz) {
  const double x = LabCurve(xyz.x / kWhiteX);
  const double y = LabCurve(xyz.y / kWhiteY);
  const double z = LabCurve(xyz.z / kWhiteZ);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

V3d LinearToLab(const V3d& linear) { return XyzToLab(LinearToXyz(linear)); }

}  // namespace rtb
