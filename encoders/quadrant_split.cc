#include "encoders/quadrant_split.h"

#include <algorithm>
#include <array>

#include "encoders/partition.h"
#include "encoders/partition_cell.h"

namespace rtb {
namespace {

using Samples = std::array<V3d, kQuadrants>;
using Values = std::array<double, kQuadrants>;

Samples Blended(Blend blend, std::span<const Rgb> linear) {
  Samples samples;
  ToBlend(blend, linear, samples);
  return samples;
}

/// Samples whose value is greater than the threshold.
SampleMask Above(const Values& values, double threshold) {
  SampleMask mask = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] > threshold + kNoise) mask |= SampleMask{1} << i;
  }
  return mask;
}

/// The channel of the largest range above its middle.
SampleMask SplitByRange(const Samples& encoded) {
  Values widest{};
  double widest_range = -1;
  double middle = 0;
  for (int channel = 0; channel < 3; ++channel) {
    Values values;
    std::ranges::transform(encoded, values.begin(),
                           [&](const V3d& color) { return color[channel]; });
    const auto [low, high] = std::ranges::minmax(values);
    if (high - low <= widest_range + kNoise) continue;
    widest = values;
    widest_range = high - low;
    middle = (low + high) / 2;
  }
  return Above(widest, middle);
}

}  // namespace

Cell BrightnessSplitCell(Blend blend, std::span<const Rgb> linear,
                         std::span<const char32_t> glyphs) {
  const Samples samples = Blended(blend, linear);
  const SampleMask on = BrighterThanMean(
      (blend == Blend::kSrgb ? samples : Blended(Blend::kSrgb, linear)).data());
  return CellOfMeans(blend, samples, on, glyphs[on]);
}

Cell RangeSplitCell(Blend blend, std::span<const Rgb> linear,
                    std::span<const char32_t> glyphs) {
  const Samples samples = Blended(blend, linear);
  const SampleMask on = BrighterSide(
      blend, samples,
      SplitByRange(blend == Blend::kSrgb ? samples
                                         : Blended(Blend::kSrgb, linear)));
  return CellOfMeans(blend, samples, on, glyphs[on]);
}

}  // namespace rtb
