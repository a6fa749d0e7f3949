/// @file
/// Tables of Sobol's direction numbers for look-ups within a vector.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "core/math/sobol_directions.h"

namespace rtb {

/// Sums of direction numbers for each digit of an index to base `entries`, a
/// power of two.
template <std::size_t kEntries>
struct SobolTables {
  static constexpr int kBits = std::bit_width(kEntries) - 1;
  static constexpr int kDigits = (32 + kBits - 1) / kBits;
  alignas(64) std::uint32_t sums[kDigits][kEntries] = {};
};

/// @param row of SobolDirections.
template <std::size_t kEntries>
constexpr SobolTables<kEntries> MakeSobolTables(int row) {
  const SobolDirections directions = MakeSobolDirections();
  SobolTables<kEntries> tables;
  for (int bit = 0; bit < 32; ++bit) {
    auto& sums = tables.sums[bit / tables.kBits];
    for (std::size_t value = 0; value < kEntries; ++value) {
      if ((value >> (bit % tables.kBits) & 1) == 0) continue;
      sums[value] ^= directions.reversed[row][bit];
    }
  }
  return tables;
}

}  // namespace rtb
