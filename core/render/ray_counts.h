/// @file
/// How many rays a rendering took.
#pragma once

#include <cstdint>

#include "core/base/host_device.h"

namespace rtb {

/// Rays traced, by kind.
struct RayCounts {
  std::uint64_t camera = 0;
  std::uint64_t reflection = 0;  ///< Mirrored, or glossily reflected (whitted).
  std::uint64_t refraction = 0;
  std::uint64_t scattered = 0;  ///< In a direction drawn from a BSDF (path).
  std::uint64_t shadow = 0;
  /// Camera rays whose paths were followed on vectors (wide/trace_paths.h).
  std::uint64_t on_vectors = 0;

  RTB_HD std::uint64_t secondary() const {
    return reflection + refraction + scattered;
  }
  RTB_HD std::uint64_t total() const { return camera + secondary() + shadow; }

  RTB_HD RayCounts& operator+=(const RayCounts& other) {
    camera += other.camera;
    reflection += other.reflection;
    refraction += other.refraction;
    scattered += other.scattered;
    shadow += other.shadow;
    on_vectors += other.on_vectors;
    return *this;
  }
  bool operator==(const RayCounts&) const = default;
};

}  // namespace rtb
