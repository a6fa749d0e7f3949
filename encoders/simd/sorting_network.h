/// @file
/// Sorting networks: compare-exchanges that sort whatever the values.
#pragma once

#include <array>
#include <cstddef>

namespace rtb {

/// Batcher's odd-even merge sort (Knuth, The Art of Computer Programming,
/// volume 3, algorithm 5.2.2M) of kCount values, a power of two: step i puts
/// the values low[i] < high[i] in order.
template <std::size_t kCount>
struct SortingNetwork {
  static constexpr std::size_t kMost = kCount * kCount / 2;
  std::array<std::size_t, kMost> low{};
  std::array<std::size_t, kMost> high{};
  std::size_t size = 0;

  constexpr SortingNetwork() {
    for (std::size_t p = 1; p < kCount; p *= 2) {
      for (std::size_t k = p; k > 0; k /= 2) {
        for (std::size_t j = k % p; j + k < kCount; j += 2 * k) {
          for (std::size_t i = j; i < j + k && i + k < kCount; ++i) {
            if (i / (2 * p) == (i + k) / (2 * p)) Add(i, i + k);
          }
        }
      }
    }
  }

 private:
  constexpr void Add(std::size_t a, std::size_t b) {
    low[size] = a;
    high[size++] = b;
  }
};

template <std::size_t kCount>
inline constexpr SortingNetwork<kCount> kSortingNetwork;

}  // namespace rtb
