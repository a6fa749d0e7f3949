/// @file
/// Affine maps p -> L p + t of three dimensions, with the scene format's
/// position / rotate / scale convention.
#pragma once

#include "core/base/host_device.h"
#include "core/math/vec.h"

namespace rtb {

/// An affine map, stored by the images of the axes and of the origin.
/// T is float (rendering) or double (scene composition).
template <class T>
struct Affine {
  using Vec = Imath::Vec3<T>;
  Vec x{1, 0, 0};       ///< Image of the first axis.
  Vec y{0, 1, 0};       ///< Image of the second axis.
  Vec z{0, 0, 1};       ///< Image of the third axis.
  Vec origin{0, 0, 0};  ///< Image of the origin.

  /// Maps a direction (no translation).
  RTB_HD Vec Direction(const Vec& v) const {
    return x * v.x + y * v.y + z * v.z;
  }
  /// Maps a point.
  RTB_HD Vec Point(const Vec& p) const { return Direction(p) + origin; }
  /// Multiplies by the transposed linear part. On the *inverse* of a map this
  /// takes a normal to the map's target space (not normalized).
  RTB_HD Vec Transposed(const Vec& n) const {
    return Vec(x.dot(n), y.dot(n), z.dot(n));
  }
  /// Determinant of the linear part.
  RTB_HD T Determinant() const { return x.dot(y.cross(z)); }
  /// The inverse map; the linear part must be regular.
  RTB_HD Affine Inverse() const {
    const T d = T(1) / Determinant();
    const Vec r0 = y.cross(z) * d;  // rows of the inverse
    const Vec r1 = z.cross(x) * d;
    const Vec r2 = x.cross(y) * d;
    Affine inverse;
    inverse.x = Vec(r0.x, r1.x, r2.x);
    inverse.y = Vec(r0.y, r1.y, r2.y);
    inverse.z = Vec(r0.z, r1.z, r2.z);
    inverse.origin = -inverse.Direction(origin);
    return inverse;
  }
  /// The map that applies `first`, then this one.
  RTB_HD Affine operator*(const Affine& first) const {
    Affine both;
    both.x = Direction(first.x);
    both.y = Direction(first.y);
    both.z = Direction(first.z);
    both.origin = Point(first.origin);
    return both;
  }
};

using Affinef = Affine<float>;
using Affined = Affine<double>;

/// The format's transform: p -> position + Rz Ry Rx (scale * p), rotations
/// about fixed axes, right-handed.
/// @param degrees rotation angles about x, y and z, in degrees.
Affined PositionRotateScale(const V3d& position, const V3d& degrees,
                            const V3d& scale);

/// The same map in single precision.
Affinef ToFloat(const Affined& map);

}  // namespace rtb
