/// @file
/// A cell of two colors from its samples, host and device: the lines that
/// partition.h's functions, quadrant_split.h's and a GPU's kernels share. The
/// counts of samples are at most kMaxPartitionSamples.
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/base/host_device.h"
#include "core/color/hsp.h"
#include "encoders/cell.h"
#include "encoders/sample_mask.h"
#include "encoders/steps.h"

namespace rtb {

inline constexpr std::size_t kMaxPartitionSamples = 8;

/// BestPartition of sRGB-encoded samples (partition.h).
RTB_HD inline SampleMask BestPartitionOfSteps(const StepColor* samples,
                                              std::size_t samples_count) {
  /// Sums and differences of steps.
  using WideSteps = Imath::Vec3<std::int64_t>;
  const auto count = static_cast<std::int64_t>(samples_count);
  const SampleMask end = SampleMask{1} << (samples_count - 1);
  // Sums over subsets, each from the one without its lowest sample.
  std::int64_t sums[1 << (kMaxPartitionSamples - 1)][3];
  sums[0][0] = sums[0][1] = sums[0][2] = 0;
  WideSteps total(0);
  for (std::size_t i = 0; i < samples_count; ++i) {
    total += WideSteps(samples[i]);
  }
  SampleMask best = 0;
  // The gain of partition.cc times `count`, as a fraction. A lead is below
  // 2^27, its square below 2^56, the products below 2^60.
  std::int64_t numerator = 0;
  std::int64_t denominator = 1;
  for (SampleMask on = 1; on < end; ++on) {
    const StepColor& lowest = samples[LowestSample(on)];
    const auto& rest = sums[on & (on - 1)];
    const WideSteps sum(rest[0] + lowest.x, rest[1] + lowest.y,
                        rest[2] + lowest.z);
    sums[on][0] = sum.x;
    sums[on][1] = sum.y;
    sums[on][2] = sum.z;
    const auto n1 = static_cast<std::int64_t>(std::popcount(on));
    const WideSteps lead = sum * count - total * n1;
    const std::int64_t gain = lead.dot(lead);
    const std::int64_t weight = n1 * (count - n1);
    if (gain * denominator <= numerator * weight) continue;
    numerator = gain;
    denominator = weight;
    best = on;
  }
  return best;
}

/// BrighterSide (partition.h).
/// @param encoded takes a color of the samples' space to sRGB-encoded values.
template <class Encoded>
RTB_HD SampleMask BrighterSideBy(const Encoded& encoded, const V3d* samples,
                                 std::size_t count, SampleMask mask) {
  const SampleMask all = AllSamples(count);
  if (mask == 0 || mask == all) return 0;
  const SampleMask other = mask ^ all;
  const double lead = HspBrightness(encoded(MeanUnder(samples, count, mask))) -
                      HspBrightness(encoded(MeanUnder(samples, count, other)));
  if (std::abs(lead) <= kNoise) return mask < other ? mask : other;
  return lead > 0 ? mask : other;
}

/// CellOfMeans (partition.h) without its checks.
/// @param code takes a color of the samples' space to 8-bit codes.
template <class Code>
RTB_HD Cell CellOfMeansBy(const Code& code, const V3d* samples,
                          std::size_t count, SampleMask on, char32_t glyph) {
  const SampleMask off = on ^ AllSamples(count);
  Cell cell;
  cell.glyph = glyph;
  cell.bg = code(MeanUnder(samples, count, off));
  if (on != 0) cell.fg = code(MeanUnder(samples, count, on));
  return cell;
}

/// The samples of a 2 x 2 cell whose HSP brightness is greater than the mean of
/// the four. @param encoded sRGB-encoded.
RTB_HD inline SampleMask BrighterThanMean(const V3d* encoded) {
  double values[4];
  for (int i = 0; i < 4; ++i) values[i] = HspBrightness(encoded[i]);
  const double mean = (values[0] + values[1] + values[2] + values[3]) / 4;
  SampleMask mask = 0;
  for (int i = 0; i < 4; ++i) {
    if (values[i] > mean + kNoise) mask |= SampleMask{1} << i;
  }
  return mask;
}

/// @name The functors of sRGB, in which samples are encoded already.
/// @{
struct SrgbAsIs {
  RTB_HD const V3d& operator()(const V3d& color) const { return color; }
};
struct SrgbCodes8 {
  RTB_HD Rgb8 operator()(const V3d& color) const {
    return {RoundHalfUp(color.x), RoundHalfUp(color.y), RoundHalfUp(color.z)};
  }
};
/// @}

}  // namespace rtb
