#include "encoders/modifiers/dither.h"

#include "core/math/random.h"

namespace rtb {
namespace {

/// Rank 0..63 in the 8 x 8 matrix: the bits of x ^ y and y interleaved, the
/// lowest first.
unsigned BayerRank(unsigned x, unsigned y) {
  unsigned rank = 0;
  for (unsigned bit = 0; bit < 3; ++bit) {
    const unsigned a = x >> bit & 1;
    const unsigned b = y >> bit & 1;
    rank = rank << 2 | (a ^ b) << 1 | b;
  }
  return rank;
}

}  // namespace

double DitherAmplitude(ColorDepth depth) {
  switch (depth) {
    case ColorDepth::k256:
      return 20.0 / 255;  // The cube's steps are 40, the first ones longer.
    case ColorDepth::k16:
      return 64.0 / 255;  // About 0, 127 and 255 a channel.
    case ColorDepth::kMono:
      return 114.0 / 255;  // 0 and 229.
    case ColorDepth::kTruecolor:
      break;
  }
  return 0;
}

double DitherOffset(Dither dither, int x, int y, std::uint64_t seed) {
  if (dither == Dither::kBayer) {
    const unsigned rank =
        BayerRank(static_cast<unsigned>(x), static_cast<unsigned>(y));
    return (2.0 * rank + 1) / 64 - 1;
  }
  if (dither == Dither::kRandom) {
    constexpr std::uint32_t kDimension = 0xD17;
    const std::uint32_t bits =
        RandomBits(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                   kDimension, seed);
    return 2.0 * static_cast<double>(UnitFloat(bits)) - 1;
  }
  return 0;
}

}  // namespace rtb
