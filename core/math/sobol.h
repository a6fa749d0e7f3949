/// @file
/// Sobol points with hash-based Owen scrambling, host and device: every
/// aligned run of 2^k points is stratified in all elementary intervals, yet
/// patterns of different seeds are independent.
///
/// Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020. A sampler
/// of more than four dimensions pads: each set of up to four dimensions has a
/// seed of its own (SobolSeed), which shuffles the order of the points too.
#pragma once

#include <cstdint>

#include "core/base/host_device.h"
#include "core/math/random.h"
#include "core/math/sobol_directions.h"
#include "core/math/vec.h"

namespace rtb {

/// The word with its bits in opposite order.
RTB_HD inline std::uint32_t ReverseBits(std::uint32_t v) {
  v = (v << 16) | (v >> 16);
  v = ((v & 0x00FF00FFu) << 8) | ((v >> 8) & 0x00FF00FFu);
  v = ((v & 0x0F0F0F0Fu) << 4) | ((v >> 4) & 0x0F0F0F0Fu);
  v = ((v & 0x33333333u) << 2) | ((v >> 2) & 0x33333333u);
  return ((v & 0x55555555u) << 1) | ((v >> 1) & 0x55555555u);
}

/// A bijection in which every bit depends on the bits below it alone: an Owen
/// scrambling of the reversed word. The idea is Laine and Karras', "Stratified
/// Sampling for Stochastic Transparency", EGSR 2011; the constants are
/// Vegdahl's, "Building a Better LK Hash", 2021, "The final hash".
RTB_HD inline std::uint32_t ScrambleReversed(std::uint32_t v,
                                             std::uint32_t seed) {
  v ^= v * 0x3D20ADEAu;
  v += seed;
  v *= (seed >> 16) | 1u;
  v ^= v * 0x05526C56u;
  v ^= v * 0x53A22864u;
  return v;
}

/// Coordinate `dimension` (0..3) of Sobol point `index`, a 32-bit fraction
/// with its bits in opposite order.
RTB_HD inline std::uint32_t SobolReversed(std::uint32_t index, int dimension) {
  if (dimension == 0) return index;  // van der Corput: the index, reversed
  static constexpr SobolSums kSums = MakeSobolSums();
  const auto& sums = kSums.sums[dimension - 1];
  return sums[0][index & 0xFFu] ^ sums[1][(index >> 8) & 0xFFu] ^
         sums[2][(index >> 16) & 0xFFu] ^ sums[3][index >> 24];
}

/// Burley 2020, shuffling: the order of the points of a pattern, itself
/// Owen-scrambled, so that aligned runs of 2^k stay such runs.
RTB_HD inline std::uint32_t ShuffledIndex(std::uint32_t index,
                                          std::uint32_t seed) {
  return ReverseBits(ScrambleReversed(ReverseBits(index), seed));
}

/// One scrambled coordinate of the point at a shuffled index, in [0, 1).
RTB_HD inline float ScrambledSobol(std::uint32_t shuffled, int dimension,
                                   std::uint32_t seed) {
  return UnitFloat(
      ReverseBits(ScrambleReversed(SobolReversed(shuffled, dimension), seed)));
}

/// The seed of one set of dimensions of one pixel (or cell).
RTB_HD inline std::uint32_t SobolSeed(std::uint32_t pixel,
                                      std::uint32_t dimension_set,
                                      std::uint64_t seed) {
  constexpr std::uint32_t kPurpose = 0x50B01u;  // apart from RandomBits' users
  return RandomBits(pixel, kPurpose, dimension_set, seed);
}

/// Point `index` of the two-dimensional pattern of a seed: any aligned 2^k
/// points hold one in each elementary interval of area 2^-k, a (0, k, 2)-net.
RTB_HD inline V2f SobolOwen2(std::uint32_t index, std::uint32_t seed) {
  const Uint4 h = Pcg4d({seed, 0x2545F491u, 0x4F6CDD1Du, 2});
  const std::uint32_t i = ShuffledIndex(index, h.x);
  return {ScrambledSobol(i, 0, h.y), ScrambledSobol(i, 1, h.z)};
}

/// The same in four dimensions: each one, and the pair of the first two, are
/// stratified as above; other pairs somewhat less.
RTB_HD inline V4f SobolOwen4(std::uint32_t index, std::uint32_t seed) {
  const Uint4 h = Pcg4d({seed, 0x2545F491u, 0x4F6CDD1Du, 4});
  const Uint4 g = Pcg4d(h);
  const std::uint32_t i = ShuffledIndex(index, h.x);
  return {ScrambledSobol(i, 0, h.y), ScrambledSobol(i, 1, h.z),
          ScrambledSobol(i, 2, h.w), ScrambledSobol(i, 3, g.x)};
}

}  // namespace rtb
