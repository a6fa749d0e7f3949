#include "tests/encoders/fit/brute_force.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/math/random.h"

namespace rtb {
namespace {

/// The squared error of one channel, multiplied out:
/// aa f^2 + 2 ab f b + bb b^2 - 2 as f - 2 bs b + ss.
struct ChannelError {
  double aa = 0, ab = 0, bb = 0, as = 0, bs = 0, ss = 0;

  ChannelError(const FitMask& mask, std::span<const V3d> samples, int channel) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const double m = mask.coverage[i];
      const double s = samples[i][channel];
      aa += m * m;
      ab += m * (1 - m);
      bb += (1 - m) * (1 - m);
      as += m * s;
      bs += (1 - m) * s;
      ss += s * s;
    }
  }

  double At(double f, double b) const {
    return aa * f * f + 2 * ab * f * b + bb * b * b - 2 * as * f - 2 * bs * b +
           ss;
  }
};

double LeastOfChannel(const FitMask& mask, Blend blend,
                      std::span<const V3d> samples, int channel) {
  std::array<double, 256> values;
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = FromRgb8(blend, {static_cast<std::uint8_t>(i), 0, 0}).x;
  }
  const ChannelError error(mask, samples, channel);
  double least = std::numeric_limits<double>::infinity();
  for (const double fg : values) {
    for (const double bg : values) least = std::min(least, error.At(fg, bg));
  }
  return least;
}

double Unit(int index, int channel, std::uint64_t seed) {
  return UnitFloat(RandomBits(static_cast<std::uint32_t>(index), 7,
                              static_cast<std::uint32_t>(channel), seed));
}

double MakeValue(SampleKind kind, int index, int channel, std::uint64_t seed) {
  const double unit = Unit(index, channel, seed);
  switch (kind) {
    case SampleKind::kRandom:
      return unit;
    case SampleKind::kGray:
      return std::floor(Unit(index, 0, seed) * 256) / 255;
    case SampleKind::kTwoColors:
      return Unit(Unit(index, 5, seed) < 0.5 ? -1 : -2, channel, seed);
    case SampleKind::kNearlyFlat:
      return 0.4 + 0.01 * unit;
    case SampleKind::kCorners:
      return unit < 0.5 ? 0 : 1;
  }
  return 0;
}

}  // namespace

double LeastErrorOfAllCodes(const FitMask& mask, Blend blend,
                            std::span<const V3d> samples) {
  double error = 0;
  for (int channel = 0; channel < 3; ++channel) {
    error += LeastOfChannel(mask, blend, samples, channel);
  }
  return error;
}

double Tolerance(double error, std::size_t samples) {
  // A code on the far side of a middle costs 2 n kNoise times half a code.
  const double codes = 3.0 * static_cast<double>(samples) * kNoise / 255;
  return kNoise * (std::sqrt(error) + kNoise) + codes;
}

std::vector<V3d> MakeSamples(SampleKind kind, int count, std::uint64_t seed) {
  std::vector<V3d> samples;
  for (int i = 0; i < count; ++i) {
    samples.emplace_back(MakeValue(kind, i, 0, seed),
                         MakeValue(kind, i, 1, seed),
                         MakeValue(kind, i, 2, seed));
  }
  return samples;
}

}  // namespace rtb
