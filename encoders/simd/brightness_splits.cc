// Encoder `quadrant` with vectors: one cell a lane.
#include "core/base/check.h"
#include "encoders/quadrant_split.h"
#include "encoders/simd/kernels.h"

// This file is compiled once for each target.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "encoders/simd/brightness_splits.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "encoders/simd/sides-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {

/// The samples above the mean brightness, bit i = sample i.
struct BrightSamples {
  Ints mask;
  FloatMask doubtful;
};

/// In steps (at most 2^21) a brightness in single precision errs by less than
/// 0.5, the mean of four by less than 0.7, a lead by less than 1.2; and the
/// scalar encoder asks for a lead of kNoise, 0.82.
HWY_INLINE BrightSamples FindBright(const ColorArray<kQuadrants>& steps) {
  const FloatLanes d;
  const IntLanes di;
  LaneArray<kQuadrants> brightness;
  for (std::size_t i = 0; i < kQuadrants; ++i) {
    brightness.Set(i, BrightnessOf(steps[i]));
  }
  const Floats mean = hn::Mul(hn::Add(hn::Add(brightness[0], brightness[1]),
                                      hn::Add(brightness[2], brightness[3])),
                              hn::Set(d, 0.25f));
  const Floats noise = hn::Set(d, static_cast<float>(kNoise * kWhiteSteps));
  Ints mask = hn::Zero(di);
  Floats nearest = hn::Set(d, 255);
  Floats highest = hn::Zero(d);
  for (std::size_t i = 0; i < kQuadrants; ++i) {
    const Floats lead = hn::Sub(brightness[i], mean);
    highest = hn::Max(highest, hn::Abs(lead));
    const Floats above = hn::Sub(lead, noise);
    nearest = hn::Min(nearest, hn::Abs(above));
    const Ints bit = hn::Set(di, 1 << static_cast<int>(i));
    mask =
        hn::Or(mask, hn::IfThenElseZero(
                         hn::RebindMask(di, hn::Gt(above, hn::Zero(d))), bit));
  }
  // Of equal brightnesses none leads by more than 0.75.
  const auto doubtful =
      hn::And(hn::Lt(nearest, hn::Set(d, 1.5f)), hn::Gt(highest, hn::Zero(d)));
  return {mask, doubtful};
}

HWY_INLINE void EncodeLanes(const float* linear,
                            std::span<const char32_t> glyphs, Cell* cells) {
  ColorArray<kQuadrants> steps;
  LoadSteps(linear, steps);
  const BrightSamples bright = FindBright(steps);
  Side on;
  Side off;
  SumSides(steps, bright.mask, on, off);
  StoreSides(on, off, GlyphOf(glyphs, bright.mask), cells);
  ForEachLane(bright.doubtful, [&](std::size_t lane) {
    cells[lane] = BrightnessSplitCell(
        Blend::kSrgb, SamplesOf<kQuadrants>(linear, lane), glyphs);
  });
}

void EncodeBrightnessCells(const float* linear,
                           std::span<const char32_t> glyphs,
                           std::span<Cell> cells) {
  ForEachBatch<3 * kQuadrants>(linear, cells,
                               [&](const float* batch, Cell* encoded) {
                                 EncodeLanes(batch, glyphs, encoded);
                               });
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace rtb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtb {

HWY_EXPORT(EncodeBrightnessCells);

void EncodeBrightnessSplits(std::span<const Rgb> samples,
                            std::span<const char32_t> glyphs,
                            std::span<Cell> cells) {
  if (cells.empty()) return;
  RTB_CHECK_EQ(samples.size(), kQuadrants * cells.size());
  RTB_CHECK_EQ(glyphs.size(), std::size_t{1} << kQuadrants);
  HWY_DYNAMIC_DISPATCH(EncodeBrightnessCells)(&samples[0].x, glyphs, cells);
}

}  // namespace rtb
#endif  // HWY_ONCE
