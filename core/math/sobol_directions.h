/// @file
/// The direction numbers of the second to fourth Sobol dimension.
#pragma once

#include <cstdint>

namespace rtb {

/// `reversed[d][k]` is direction number k of dimension d + 1 (the first
/// dimension, 0, needs none), with its 32 bits in opposite order: bit 0 is the
/// fraction's 1/2.
struct SobolDirections {
  std::uint32_t reversed[3][32] = {};
};

/// Direction numbers m_k by the recurrence of Joe and Kuo, "Constructing Sobol
/// Sequences with Better Two-Dimensional Projections", SIAM J. Sci. Comput. 30,
/// 2008, from the primitive polynomials and initial numbers of their table
/// new-joe-kuo-6, dimensions 2 to 4.
constexpr SobolDirections MakeSobolDirections() {
  struct Polynomial {
    int degree;
    std::uint32_t inner;       // coefficients a_1 .. a_(degree - 1), as bits
    std::uint32_t initial[3];  // m_1 .. m_degree
  };
  constexpr Polynomial kPolynomials[3] = {
      {1, 0, {1}}, {2, 1, {1, 3}}, {3, 1, {1, 3, 1}}};
  SobolDirections table;
  for (int d = 0; d < 3; ++d) {
    const Polynomial& p = kPolynomials[d];
    std::uint32_t m[32] = {};
    for (int k = 0; k < 32; ++k) {
      if (k < p.degree) {
        m[k] = p.initial[k];
      } else {
        m[k] = m[k - p.degree] ^ (m[k - p.degree] << p.degree);
        for (int i = 1; i < p.degree; ++i) {
          if ((p.inner >> (p.degree - 1 - i)) & 1u) m[k] ^= m[k - i] << i;
        }
      }
      // m_k / 2^(k + 1) as a fraction: its bit j stands for 2^(j - k - 1).
      for (int j = 0; j <= k; ++j) {
        table.reversed[d][k] |= ((m[k] >> j) & 1u) << (k - j);
      }
    }
  }
  return table;
}

/// Sums of direction numbers: `sums[d][b][v]` is that of the numbers 8 b + j
/// for each bit j of v that is set. Four look-ups take the place of a loop over
/// 32 bits that nobody can predict.
struct SobolSums {
  std::uint32_t sums[3][4][256] = {};
};

constexpr SobolSums MakeSobolSums() {
  constexpr SobolDirections kDirections = MakeSobolDirections();
  SobolSums table;
  for (int d = 0; d < 3; ++d) {
    for (int byte = 0; byte < 4; ++byte) {
      for (unsigned value = 1; value < 256; ++value) {
        int bit = 0;
        while (((value >> bit) & 1u) == 0) ++bit;
        table.sums[d][byte][value] = table.sums[d][byte][value & (value - 1)] ^
                                     kDirections.reversed[d][8 * byte + bit];
      }
    }
  }
  return table;
}

}  // namespace rtb
