/// @file
/// Stratified sample positions on the unit square.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/base/host_device.h"
#include "core/math/random.h"
#include "core/math/vec.h"

namespace rtb {

/// Hashes of one pattern, told apart by purpose.
RTB_HD inline std::uint32_t PatternHash(std::uint32_t value,
                                        std::uint32_t pattern,
                                        std::uint32_t purpose) {
  return Pcg4d({value, pattern, purpose, 0x6A09E667u}).x;
}

/// A permutation of [0, length): ranks are swapped by cycle walking over a
/// keyed bijection of the next power of two (Kensler 2013, section 3; the
/// bijection here is a chain of odd multiplications and xor-shifts).
RTB_HD inline std::uint32_t Permute(std::uint32_t i, std::uint32_t length,
                                    std::uint32_t key) {
  std::uint32_t mask = length - 1;
  for (int shift = 1; shift < 32; shift *= 2) mask |= mask >> shift;
  do {
    for (std::uint32_t round = 0; round < 4; ++round) {
      const std::uint32_t bits = PatternHash(round, key, 0);
      i = (i ^ bits) & mask;
      i = (i * (PatternHash(round, key, 1) | 1u)) & mask;
      i ^= i >> 3;
      i ^= i >> 7;
    }
  } while (i >= length);
  return (i + key % length) % length;
}

/// Position `index` of `count` correlated multi-jittered samples of the unit
/// square: stratified in two dimensions and in each of them, for any count.
/// Kensler, "Correlated Multi-Jittered Sampling", Pixar TM 13-01, 2013,
/// listing 4 (arbitrary sample counts).
/// @param pattern selects one of 2^32 patterns.
RTB_HD inline V2f MultiJittered(std::uint32_t index, std::uint32_t count,
                                std::uint32_t pattern) {
  const auto m = std::max(
      1u, static_cast<std::uint32_t>(std::sqrt(static_cast<float>(count))));
  const std::uint32_t n = (count + m - 1) / m;
  const std::uint32_t s = Permute(index, count, PatternHash(0, pattern, 2));
  const std::uint32_t sx = Permute(s % m, m, PatternHash(1, pattern, 2));
  const std::uint32_t sy = Permute(s / m, n, PatternHash(2, pattern, 2));
  const float jx = UnitFloat(PatternHash(s, pattern, 3));
  const float jy = UnitFloat(PatternHash(s, pattern, 4));
  const float x = (static_cast<float>(sx) +
                   (static_cast<float>(sy) + jx) / static_cast<float>(n)) /
                  static_cast<float>(m);
  const float y = (static_cast<float>(s) + jy) / static_cast<float>(count);
  constexpr float kBelowOne = 0x1.fffffep-1f;
  return V2f(std::min(x, kBelowOne), std::min(y, kBelowOne));
}

}  // namespace rtb
