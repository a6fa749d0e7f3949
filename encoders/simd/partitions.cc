// The best two-way partitions of many cells at once: one cell a lane, all
// partitions one after the other.
#include "core/base/check.h"
#include "encoders/partition.h"
#include "encoders/simd/kernels.h"

// This file is compiled once for each target.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "encoders/simd/partitions.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "encoders/simd/sides-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {

/// The best partition of each cell, bit i = sample i.
struct Partition {
  Ints mask;
  FloatMask doubtful;  ///< Another one is as good, as far as floats can tell.
};

/// Sums of the samples `first` to first + kBits - 1 over all their subsets.
template <std::size_t kBits, std::size_t kSamples>
HWY_INLINE void SumSubsets(const ColorArray<kSamples>& samples,
                           std::size_t first, ColorArray<1 << kBits>& sums) {
  const Floats zero = hn::Zero(FloatLanes());
  sums.Set(0, {zero, zero, zero});
  for (std::size_t bit = 0; bit < kBits; ++bit) {
    const ColorLanes sample = samples[first + bit];
    const std::size_t half = std::size_t{1} << bit;
    for (std::size_t i = 0; i < half; ++i) sums.Set(half + i, sums[i] + sample);
  }
}

/// Differences from the mean. Taking the first sample off beforehand makes
/// their errors small against the largest of them: 2^-23 of it.
template <std::size_t kSamples>
HWY_INLINE void Center(const ColorArray<kSamples>& steps,
                       ColorArray<kSamples>& centered) {
  const Floats zero = hn::Zero(FloatLanes());
  ColorLanes sum{zero, zero, zero};
  for (std::size_t i = 1; i < kSamples; ++i) sum = sum + (steps[i] - steps[0]);
  const ColorLanes mean = sum * hn::Set(FloatLanes(), 1.0f / kSamples);
  for (std::size_t i = 0; i < kSamples; ++i) {
    centered.Set(i, (steps[i] - steps[0]) - mean);
  }
}

/// What a split takes off the squared error is n / (n1 n2) |D|^2, D the sum
/// over one side of the samples' differences from their mean (partition.cc).
/// Let M be the largest difference. The best split gains at least M^2, what
/// splitting that sample off does. A sum of up to 7 differences errs by less
/// than 30 M / 2^24, hence a gain by less than 2^-16 of the best one: splits
/// within 2^-14 of it are doubtful.
template <std::size_t kSamples>
HWY_INLINE Partition FindBest(const ColorArray<kSamples>& steps) {
  constexpr std::size_t kLowBits = std::min<std::size_t>(kSamples - 1, 3);
  constexpr std::size_t kHighBits = kSamples - 1 - kLowBits;
  const FloatLanes d;
  const IntLanes di;
  ColorArray<kSamples> centered;
  Center(steps, centered);
  ColorArray<1 << kLowBits> low;
  ColorArray<1 << kHighBits> high;
  SumSubsets<kLowBits>(centered, 0, low);
  SumSubsets<kHighBits>(centered, kLowBits, high);
  Floats best = hn::Zero(d);
  Floats second = hn::Zero(d);
  Ints mask = hn::Zero(di);
  for (unsigned h = 0; h < 1u << kHighBits; ++h) {
    const ColorLanes base = high[h];
    for (unsigned l = h == 0 ? 1 : 0; l < 1u << kLowBits; ++l) {
      const ColorLanes sum = base + low[l];
      const unsigned on = h << kLowBits | l;
      const auto n1 = static_cast<float>(std::popcount(on));
      const Floats weight = hn::Set(d, 1 / (n1 * (kSamples - n1)));
      const Floats gain = hn::Mul(
          weight, hn::MulAdd(sum.r, sum.r,
                             hn::MulAdd(sum.g, sum.g, hn::Mul(sum.b, sum.b))));
      const auto better = hn::Gt(gain, best);
      mask = hn::IfThenElse(hn::RebindMask(di, better),
                            hn::Set(di, static_cast<int>(on)), mask);
      second = hn::Max(second, hn::Min(best, gain));
      best = hn::Max(best, gain);
    }
  }
  const auto close = hn::Gt(second, hn::Mul(best, hn::Set(d, 1 - 0x1p-14f)));
  return {mask, close};
}

/// How much brighter the mean of side `a` is, in steps; errs by less than 1.5.
HWY_INLINE Floats BrightnessLead(const Side& a, const Side& b) {
  const auto brightness = [](const Side& side) {
    const Floats one = hn::Set(FloatLanes(), 1);
    return BrightnessOf(side.sum * hn::Div(one, hn::Max(side.count, one)));
  };
  return hn::Sub(brightness(a), brightness(b));
}

/// Encodes as many cells as there are lanes.
template <std::size_t kSamples>
HWY_INLINE void EncodeLanes(const float* linear,
                            std::span<const char32_t> glyphs, Cell* cells) {
  const FloatLanes d;
  const IntLanes di;
  ColorArray<kSamples> steps;
  LoadSteps(linear, steps);
  const Partition found = FindBest(steps);
  Side on;
  Side off;
  SumSides(steps, found.mask, on, off);
  const Floats lead = BrightnessLead(on, off);
  const auto split = hn::RebindMask(d, hn::Gt(found.mask, hn::Zero(di)));
  const auto swap = hn::And(split, hn::Lt(lead, hn::Zero(d)));
  const Ints all = hn::Set(di, (1 << kSamples) - 1);
  const Ints mask = hn::IfThenElse(hn::RebindMask(di, swap),
                                   hn::Sub(all, found.mask), found.mask);
  StoreSides(SelectSide(swap, off, on), SelectSide(swap, on, off),
             GlyphOf(glyphs, mask), cells);
  // Leads up to kNoise, 0.82 steps, are none.
  const auto even = hn::Lt(hn::Abs(lead), hn::Set(d, 3));
  ForEachLane(hn::And(split, hn::Or(found.doubtful, even)),
              [&](std::size_t lane) {
                cells[lane] = BestPartitionCell(
                    Blend::kSrgb, SamplesOf<kSamples>(linear, lane), glyphs);
              });
}

template <std::size_t kSamples>
HWY_INLINE void EncodeAll(const float* linear, std::span<const char32_t> glyphs,
                          std::span<Cell> cells) {
  ForEachBatch<3 * kSamples>(linear, cells,
                             [&](const float* batch, Cell* encoded) {
                               EncodeLanes<kSamples>(batch, glyphs, encoded);
                             });
}

void EncodePartitionCells(const float* linear, std::span<const char32_t> glyphs,
                          std::span<Cell> cells) {
  switch (glyphs.size()) {
    case 16:
      return EncodeAll<4>(linear, glyphs, cells);
    case 64:
      return EncodeAll<6>(linear, glyphs, cells);
    default:
      return EncodeAll<8>(linear, glyphs, cells);
  }
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace rtb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtb {

HWY_EXPORT(EncodePartitionCells);

void EncodePartitions(std::span<const Rgb> samples,
                      std::span<const char32_t> glyphs, std::span<Cell> cells) {
  if (cells.empty()) return;
  const std::size_t per_cell = samples.size() / cells.size();
  RTB_CHECK_EQ(per_cell * cells.size(), samples.size());
  RTB_CHECK(per_cell == 4 || per_cell == 6 || per_cell == 8);
  RTB_CHECK_EQ(glyphs.size(), std::size_t{1} << per_cell);
  HWY_DYNAMIC_DISPATCH(EncodePartitionCells)(&samples[0].x, glyphs, cells);
}

}  // namespace rtb
#endif  // HWY_ONCE
