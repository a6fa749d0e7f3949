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

/// The hashes of one permutation, for whoever asks it for many ranks.
struct PermutationKey {
  std::uint32_t key;
  std::uint32_t bits[4];
  std::uint32_t factors[4];  ///< Odd.

  RTB_HD explicit PermutationKey(std::uint32_t seed) : key(seed) {
    for (std::uint32_t round = 0; round < 4; ++round) {
      bits[round] = PatternHash(round, key, 0);
      factors[round] = PatternHash(round, key, 1) | 1u;
    }
  }
};

/// A permutation of [0, length): ranks are swapped by cycle walking over a
/// keyed bijection of the next power of two (Kensler 2013, section 3; the
/// bijection here is a chain of odd multiplications and xor-shifts).
RTB_HD inline std::uint32_t Permute(std::uint32_t i, std::uint32_t length,
                                    const PermutationKey& key) {
  std::uint32_t mask = length - 1;
  for (int shift = 1; shift < 32; shift *= 2) mask |= mask >> shift;
  do {
    for (int round = 0; round < 4; ++round) {
      i = (i ^ key.bits[round]) & mask;
      i = (i * key.factors[round]) & mask;
      i ^= i >> 3;
      i ^= i >> 7;
    }
  } while (i >= length);
  return (i + key.key % length) % length;
}

/// The same of one rank.
RTB_HD inline std::uint32_t Permute(std::uint32_t i, std::uint32_t length,
                                    std::uint32_t key) {
  return Permute(i, length, PermutationKey(key));
}

/// `count` correlated multi-jittered samples of the unit square: stratified in
/// two dimensions and in each of them, for any count. Kensler, "Correlated
/// Multi-Jittered Sampling", Pixar TM 13-01, 2013, listing 4 (arbitrary sample
/// counts).
class MultiJitter {
 public:
  /// @param pattern selects one of 2^32 patterns.
  RTB_HD MultiJitter(std::uint32_t count, std::uint32_t pattern)
      : count_(count),
        pattern_(pattern),
        m_(std::max(1u, static_cast<std::uint32_t>(
                            std::sqrt(static_cast<float>(count))))),
        n_((count + m_ - 1) / m_),
        order_(PatternHash(0, pattern, 2)),
        columns_(PatternHash(1, pattern, 2)),
        rows_(PatternHash(2, pattern, 2)) {}

  /// Position `index` of them.
  RTB_HD V2f At(std::uint32_t index) const {
    const std::uint32_t s = Permute(index, count_, order_);
    const std::uint32_t sx = Permute(s % m_, m_, columns_);
    const std::uint32_t sy = Permute(s / m_, n_, rows_);
    const float jx = UnitFloat(PatternHash(s, pattern_, 3));
    const float jy = UnitFloat(PatternHash(s, pattern_, 4));
    const float x = (static_cast<float>(sx) +
                     (static_cast<float>(sy) + jx) / static_cast<float>(n_)) /
                    static_cast<float>(m_);
    const float y = (static_cast<float>(s) + jy) / static_cast<float>(count_);
    constexpr float kBelowOne = 0x1.fffffep-1f;
    return V2f(std::min(x, kBelowOne), std::min(y, kBelowOne));
  }

 private:
  std::uint32_t count_;
  std::uint32_t pattern_;
  std::uint32_t m_;  ///< Columns.
  std::uint32_t n_;  ///< Rows.
  PermutationKey order_;
  PermutationKey columns_;
  PermutationKey rows_;
};

/// Position `index` of `count` samples of a pattern.
RTB_HD inline V2f MultiJittered(std::uint32_t index, std::uint32_t count,
                                std::uint32_t pattern) {
  return MultiJitter(count, pattern).At(index);
}

}  // namespace rtb
