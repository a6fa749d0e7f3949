/// @file
/// TripleIndex: numbers distinct triples in the order of their first use. It
/// is how vertices are merged: by position, or by the indices of a corner.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace rtb {

/// Three words that name one thing together.
using Triple = std::array<std::uint32_t, 3>;

class TripleIndex {
 public:
  /// The number of a triple, from 0, and whether it is new.
  std::pair<int, bool> Number(const Triple& triple) {
    const auto next = static_cast<int>(numbers_.size());
    const auto [place, added] = numbers_.emplace(triple, next);
    return {place->second, added};
  }

 private:
  struct Hash {
    std::size_t operator()(const Triple& t) const {
      // Fibonacci hashing: Knuth, TAOCP volume 3, section 6.4. The upper half
      // is folded in because tables use the lower bits.
      constexpr std::uint64_t kGolden = 0x9E3779B97F4A7C15u;
      std::uint64_t hash = 0;
      for (const std::uint32_t word : t) {
        hash = (hash + word + 1) * kGolden;
        hash ^= hash >> 32;
      }
      return hash;
    }
  };
  std::unordered_map<Triple, int, Hash> numbers_;
};

}  // namespace rtb
