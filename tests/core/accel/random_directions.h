/// @file
/// Random numbers and directions for tests that shoot rays.
#pragma once

#include <cstdint>

#include "core/math/random.h"
#include "core/math/vec.h"

namespace rtb::testing {

/// Number i of a dimension, uniform in [0, 1).
inline float Uniform(std::uint32_t i, std::uint32_t dimension,
                     std::uint64_t seed) {
  return UnitFloat(RandomBits(i, 0, dimension, seed));
}

/// Unit vector i; towards the corners of a cube more often than elsewhere.
inline V3f RandomDirection(std::uint32_t i, std::uint64_t seed) {
  V3f v(0);
  for (unsigned axis = 0; axis < 3; ++axis) {
    v[static_cast<int>(axis)] = 2 * Uniform(i, axis, seed) - 1;
  }
  return v.normalized();
}

}  // namespace rtb::testing
