/// @file
/// How many rays a rendering took.
#pragma once

#include <cstdint>

namespace rtb {

/// Rays traced, by kind.
struct RayCounts {
  std::uint64_t camera = 0;
  std::uint64_t shadow = 0;
  std::uint64_t secondary = 0;  ///< Reflection and refraction rays.
};

}  // namespace rtb
