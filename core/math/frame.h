/// @file
/// Orthonormal frames around a direction.
#pragma once

#include <cmath>

#include "core/base/host_device.h"
#include "core/math/vec.h"

namespace rtb {

/// Two unit vectors that complete a normal to a right-handed frame:
/// s x t = n.
template <class T>
struct Tangents {
  Imath::Vec3<T> s, t;
};

/// The frame around a unit vector after Duff et al., "Building an Orthonormal
/// Basis, Revisited", JCGT 6(1), 2017, listing 3.
template <class T>
RTB_HD Tangents<T> TangentsOf(const Imath::Vec3<T>& n) {
  const T sign = std::copysign(T(1), n.z);
  const T a = T(-1) / (sign + n.z);
  const T b = n.x * n.y * a;
  return {Imath::Vec3<T>(T(1) + sign * n.x * n.x * a, sign * b, -sign * n.x),
          Imath::Vec3<T>(b, sign + n.y * n.y * a, -n.y)};
}

}  // namespace rtb
