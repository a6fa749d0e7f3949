#include "encoders/partition.h"

#include <array>
#include <bit>
#include <cmath>

#include "core/base/check.h"
#include "encoders/partition_cell.h"

namespace rtb {
namespace {

constexpr std::size_t kMaxSamples = kMaxPartitionSamples;

V3d SumOf(std::span<const V3d> samples, SampleMask mask) {
  V3d sum(0);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if ((mask >> i & 1) != 0) sum += samples[i];
  }
  return sum;
}

}  // namespace

SampleMask BestPartition(std::span<const V3d> samples) {
  RTB_CHECK_LE(samples.size(), kMaxSamples);
  const auto count = static_cast<double>(samples.size());
  const V3d total = SumOf(samples, AllSamples(samples.size()));
  const SampleMask end = SampleMask{1} << (samples.size() - 1);
  // Sums over subsets, each from the one without its lowest sample.
  std::array<V3d, 1 << (kMaxSamples - 1)> sums;
  sums[0] = V3d(0);
  SampleMask best = 0;
  double to_beat = 0;
  for (SampleMask on = 1; on < end; ++on) {
    const auto lowest = static_cast<std::size_t>(std::countr_zero(on));
    sums[on] = sums[on & (on - 1)] + samples[lowest];
    // What a split takes off the squared error around the common mean is
    // n1 n2 / n |m1 - m2|^2 = |n s1 - n1 s|^2 / (n n1 n2), s1 the sum over
    // side 1 and s over all: exactly 0 for samples that are alike.
    const auto n1 = static_cast<double>(std::popcount(on));
    const V3d lead = count * sums[on] - n1 * total;
    const double gain = lead.length2() / (count * n1 * (count - n1));
    if (gain > to_beat) {
      to_beat = gain + kNoise * std::sqrt(gain);
      best = on;
    }
  }
  return best;
}

SampleMask BestPartition(std::span<const StepColor> samples) {
  RTB_CHECK_LE(samples.size(), kMaxSamples);
  return BestPartitionOfSteps(samples.data(), samples.size());
}

SampleMask BrighterSide(Blend blend, std::span<const V3d> samples,
                        SampleMask mask) {
  const auto encoded = [blend](const V3d& color) {
    return ToEncoded(blend, color);
  };
  return BrighterSideBy(encoded, samples.data(), samples.size(), mask);
}

Cell CellOfMeans(Blend blend, std::span<const V3d> samples, SampleMask on,
                 char32_t glyph) {
  RTB_CHECK(on != AllSamples(samples.size()));
  const auto code = [blend](const V3d& color) { return ToRgb8(blend, color); };
  return CellOfMeansBy(code, samples.data(), samples.size(), on, glyph);
}

Cell BestPartitionCell(Blend blend, std::span<const Rgb> linear,
                       std::span<const char32_t> glyphs) {
  RTB_CHECK_LE(linear.size(), kMaxSamples);
  std::array<V3d, kMaxSamples> buffer;
  const auto samples = std::span(buffer).first(linear.size());
  ToBlend(blend, linear, samples);
  SampleMask mask = 0;
  if (blend == Blend::kSrgb) {
    std::array<StepColor, kMaxSamples> steps;
    EncodedSteps(linear, std::span(steps).first(linear.size()));
    mask = BestPartition(std::span(steps).first(linear.size()));
  } else {
    mask = BestPartition(samples);
  }
  const SampleMask on = BrighterSide(blend, samples, mask);
  return CellOfMeans(blend, samples, on, glyphs[on]);
}

}  // namespace rtb
