/// @file
/// MultiJitter (sampling.h) on vectors of indices (Highway; for inclusion per
/// target).

// Highway's guard, which flips with each target, in place of #pragma once.
#if defined(RTB_CORE_RENDER_WIDE_JITTER_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTB_CORE_RENDER_WIDE_JITTER_INL_H_
#undef RTB_CORE_RENDER_WIDE_JITTER_INL_H_
#else
#define RTB_CORE_RENDER_WIDE_JITTER_INL_H_
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>

#include "core/math/sampling.h"
#include "core/render/wide/lanes-inl.h"
#include "core/render/wide/random-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {
namespace wide {

/// The pattern of one sample.
class Jitter {
 public:
  Jitter(std::uint32_t count, std::uint32_t pattern)
      : pattern_(pattern), count_(count) {
    const auto root = std::sqrt(static_cast<float>(count));
    m_ = std::max(1u, static_cast<std::uint32_t>(root));
    n_ = (count + m_ - 1) / m_;
    HashKeys();
  }

  struct Position {
    F x, y;
  };

  /// MultiJitter::At. Counts are below 2^22, so that quotients of floats,
  /// rounded, have the right integer part.
  HWY_INLINE Position At(U index) const {
    const F one_below = Set(0x1.fffffep-1f);
    const U s = Permuted(index, count_, 0);
    const Divisor m(static_cast<float>(m_)), n(static_cast<float>(n_));
    const U row = Integer(Float(s) / m);
    const F sx = Float(Permuted(s - row * SetU(m_), m_, 1));
    const F sy = Float(Permuted(row, n_, 2));
    const F jx = UnitFloat(Hash(s, SetU(pattern_), SetU(3)));
    const F jy = UnitFloat(Hash(s, SetU(pattern_), SetU(4)));
    const F x = (sx + (sy + jx) / n) / m;
    const F y = (Float(s) + jy) / Divisor(static_cast<float>(count_));
    return {hn::Min(x, one_below), hn::Min(y, one_below)};
  }

 private:
  static constexpr int kKeys = 3;    ///< Order, columns, rows.
  static constexpr int kHashes = 8;  ///< Of each: four of bits, then factors.

  static HWY_INLINE F Float(U v) {
    return hn::ConvertTo(DF(), hn::BitCast(DI(), v));
  }
  static HWY_INLINE U Integer(F v) {
    return hn::BitCast(DU(), hn::ConvertTo(DI(), v));
  }

  /// PatternHash.
  static HWY_INLINE U Hash(U value, U pattern, U purpose) {
    return Pcg4d({value, pattern, purpose, SetU(0x6A09E667u)}).x;
  }

  /// The three PermutationKeys.
  void HashKeys() {
    alignas(64) std::uint32_t value[32] = {}, key[32] = {}, purpose[32] = {};
    for (std::uint32_t k = 0; k < kKeys; ++k) {
      keys_[k] = PatternHash(k, pattern_, 2);
      for (std::uint32_t i = 0; i < kHashes; ++i) {
        value[k * kHashes + i] = i % 4;
        key[k * kHashes + i] = keys_[k];
        purpose[k * kHashes + i] = i / 4;
      }
    }
    for (std::size_t i = 0; i < kKeys * kHashes; i += hn::Lanes(DU())) {
      const U hash = Hash(hn::Load(DU(), value + i), hn::Load(DU(), key + i),
                          hn::Load(DU(), purpose + i));
      hn::Store(hash, DU(), hashes_ + i);
    }
  }

  /// Permute.
  HWY_INLINE U Permuted(U i, std::uint32_t length, std::uint32_t k) const {
    std::uint32_t mask = length - 1;
    for (int shift = 1; shift < 32; shift *= 2) mask |= mask >> shift;
    auto walking = i == i;
    U found = i;
    do {
      found = hn::IfThenElse(walking, Step(found, SetU(mask), k), found);
      walking = hn::And(walking, found > SetU(length - 1));
    } while (!hn::AllFalse(DU(), walking));
    const U turned = found + SetU(keys_[k] % length);
    return hn::Min(turned, turned - SetU(length));  // wraps where it is less
  }
  HWY_INLINE U Step(U i, U mask, std::uint32_t k) const {
    const std::uint32_t* hashes = hashes_ + k * kHashes;
    for (int round = 0; round < 4; ++round) {
      i = hn::And(i ^ SetU(hashes[round]), mask);
      i = hn::And(i * SetU(hashes[4 + round] | 1u), mask);
      i = i ^ hn::ShiftRight<3>(i);
      i = i ^ hn::ShiftRight<7>(i);
    }
    return i;
  }

  std::uint32_t pattern_, count_, m_, n_;
  std::uint32_t keys_[kKeys];
  alignas(64) std::uint32_t hashes_[32];
};

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace wide
}  // namespace HWY_NAMESPACE
}  // namespace rtb
HWY_AFTER_NAMESPACE();

#endif  // RTB_CORE_RENDER_WIDE_JITTER_INL_H_
