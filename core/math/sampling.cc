#include "core/math/sampling.h"

#include <algorithm>
#include <cmath>

#include "core/math/random.h"

namespace rtb {
namespace {

/// Hashes of one pattern, told apart by purpose.
std::uint32_t HashOf(std::uint32_t value, std::uint32_t pattern,
                     std::uint32_t purpose) {
  return Pcg4d({value, pattern, purpose, 0x6A09E667u}).x;
}

/// A permutation of [0, length): ranks are swapped by cycle walking over a
/// keyed bijection of the next power of two (Kensler 2013, section 3; the
/// bijection here is a chain of odd multiplications and xor-shifts).
std::uint32_t Permute(std::uint32_t i, std::uint32_t length,
                      std::uint32_t key) {
  std::uint32_t mask = length - 1;
  for (int shift = 1; shift < 32; shift *= 2) mask |= mask >> shift;
  do {
    for (std::uint32_t round = 0; round < 4; ++round) {
      const std::uint32_t bits = HashOf(round, key, 0);
      i = (i ^ bits) & mask;
      i = (i * (HashOf(round, key, 1) | 1u)) & mask;
      i ^= i >> 3;
      i ^= i >> 7;
    }
  } while (i >= length);
  return (i + key) % length;
}

}  // namespace

V2f MultiJittered(std::uint32_t index, std::uint32_t count,
                  std::uint32_t pattern) {
  const auto m = std::max(
      1u, static_cast<std::uint32_t>(std::sqrt(static_cast<float>(count))));
  const std::uint32_t n = (count + m - 1) / m;
  const std::uint32_t s = Permute(index, count, HashOf(0, pattern, 2));
  const std::uint32_t sx = Permute(s % m, m, HashOf(1, pattern, 2));
  const std::uint32_t sy = Permute(s / m, n, HashOf(2, pattern, 2));
  const float jx = UnitFloat(HashOf(s, pattern, 3));
  const float jy = UnitFloat(HashOf(s, pattern, 4));
  const auto to_float = [](std::uint32_t v) { return static_cast<float>(v); };
  const float x =
      (to_float(sx) + (to_float(sy) + jx) / to_float(n)) / to_float(m);
  const float y = (to_float(s) + jy) / to_float(count);
  constexpr float kBelowOne = 0x1.fffffep-1f;
  return V2f(std::min(x, kBelowOne), std::min(y, kBelowOne));
}

}  // namespace rtb
