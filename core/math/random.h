/// @file
/// Counter-based random numbers: a hash of what a number is for, never a
/// shared stream, so that results do not depend on the order of work.
#pragma once

#include <cstdint>

#include "core/base/host_device.h"

namespace rtb {

/// Four 32-bit words.
struct Uint4 {
  std::uint32_t x, y, z, w;
};

/// pcg4d: Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 9(3),
/// 2020, section 4.2.
RTB_HD inline Uint4 Pcg4d(Uint4 v) {
  v = {v.x * 1664525u + 1013904223u, v.y * 1664525u + 1013904223u,
       v.z * 1664525u + 1013904223u, v.w * 1664525u + 1013904223u};
  v.x += v.y * v.w;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v.w += v.y * v.z;
  v = {v.x ^ (v.x >> 16), v.y ^ (v.y >> 16), v.z ^ (v.z >> 16),
       v.w ^ (v.w >> 16)};
  v.x += v.y * v.w;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v.w += v.y * v.z;
  return v;
}

/// 32 random bits for one dimension of one sample of one pixel (or cell).
RTB_HD inline std::uint32_t RandomBits(std::uint32_t pixel,
                                       std::uint32_t sample,
                                       std::uint32_t dimension,
                                       std::uint64_t seed) {
  const auto low = static_cast<std::uint32_t>(seed);
  const auto high = static_cast<std::uint32_t>(seed >> 32);
  return Pcg4d({pixel, sample, dimension ^ (high * 0x9E3779B9u), low}).x;
}

/// Uniform in [0, 1): a multiple of 2^-24.
RTB_HD inline float UnitFloat(std::uint32_t bits) {
  return static_cast<float>(bits >> 8) * 0x1p-24f;
}

}  // namespace rtb
