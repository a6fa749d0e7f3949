#include "encoders/modifiers/judge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "encoders/fit/fit.h"
#include "encoders/modifiers/median.h"
#include "encoders/modifiers/temporal.h"
#include "encoders/palette.h"

namespace rtb {
namespace {

/// The palette's color nearest to one that is not of it.
Rgb8 NearestOf(const FitPalette& palette, Rgb8 color) {
  V3d value(0);
  const Rgb linear = Decode8(color);
  ToBlend(palette.blend(), std::span(&linear, 1), std::span(&value, 1));
  const auto nearest = std::ranges::min_element(
      palette.values(), {},
      [&value](const V3d& entry) { return (entry - value).length2(); });
  return palette
      .colors()[static_cast<std::size_t>(nearest - palette.values().begin())];
}

}  // namespace

CellJudge::CellJudge(const JudgeOptions& options, const SamplesByCell& samples,
                     const SampledMasks& masks)
    : options_(options), samples_(samples), masks_(masks) {
  if (options.depth == ColorDepth::k256 || options.depth == ColorDepth::k16) {
    palette_.emplace(options.modifiers.blend, PaletteColors(options.depth));
  }
}

double CellJudge::Noise(int index) const {
  const Modifiers& modifiers = options_.modifiers;
  return options_.noise *
         (modifiers.sigma ? *modifiers.sigma
                          : NoiseOf(modifiers.blend, samples_.cell(index)));
}

V3d CellJudge::MeanShown(int index, const Cell& cell) const {
  FitMask storage;
  const FitMask& mask = masks_.Of(cell.glyph, index, storage);
  const std::array<Rgb, 2> linear = {Decode8(cell.fg), Decode8(cell.bg)};
  std::array<V3d, 2> colors{V3d(0), V3d(0)};
  ToBlend(options_.modifiers.blend, linear, colors);
  const double covered = mask.sum / mask.size();
  return covered * colors[0] + (1 - covered) * colors[1];
}

MeanChange CellJudge::ChangeOf(int index, const Cell& cell,
                               const Cell& last) const {
  const double sigma = Noise(index);
  const double traced =
      options_.weight * static_cast<double>(samples_.cell(index).size());
  return {MeanShown(index, cell) - MeanShown(index, last),
          sigma * sigma / traced};
}

Cell CellJudge::Choose(int index, const Cell& cell, const Cell* last,
                       bool drifted) const {
  const auto seen = samples_.cell(index);
  const Blend blend = options_.modifiers.blend;
  std::vector<V3d> samples;
  samples.reserve(seen.size());
  for (const CellSample& sample : seen) {
    V3d& value = samples.emplace_back(0);
    ToBlend(blend, std::span(&sample.linear, 1), std::span(&value, 1));
  }
  FitMask storage;
  FitMask last_storage;
  const FitMask& mask = masks_.Of(cell.glyph, index, storage);
  const Cell colored = Recolor(cell, mask, samples);
  if (last == nullptr) return colored;
  const StabilityTest test{options_.modifiers.temporal, Noise(index),
                           options_.partitions};
  const FitMask& last_mask = masks_.Of(last->glyph, index, last_storage);
  return KeepOrReplace(
      test, {colored, mask}, {*last, last_mask}, blend, samples,
      options_.weight, drifted, [&](const JudgedCell& judged) {
        return Recolor(Refit(judged.cell, judged.mask, samples), judged.mask,
                       samples);
      });
}

Cell CellJudge::Refit(const Cell& cell, const FitMask& mask,
                      std::span<const V3d> samples) const {
  if (options_.depth == ColorDepth::kMono) return cell;
  const CellFit fit =
      palette_ ? RefitToPalette(mask, *palette_, samples)
               : RefitColors(mask, options_.modifiers.blend, samples);
  return {cell.glyph, fit.cell.fg, fit.cell.bg};
}

Cell CellJudge::Recolor(const Cell& cell, const FitMask& mask,
                        std::span<const V3d> samples) const {
  if (options_.modifiers.color != ColorRule::kMedian ||
      options_.depth == ColorDepth::kMono) {
    return cell;
  }
  Cell colored =
      WithMedianColors(cell, mask, options_.modifiers.blend, samples);
  if (palette_) {
    colored.fg = NearestOf(*palette_, colored.fg);
    colored.bg = NearestOf(*palette_, colored.bg);
  }
  return colored;
}

double NoiseOf(Blend blend, std::span<const CellSample> samples) {
  constexpr float kStep = 1e-3f;
  double sum = 0;
  for (const CellSample& sample : samples) {
    const float gray = std::clamp(
        (sample.linear.x + sample.linear.y + sample.linear.z) / 3, 0.0f, 1.0f);
    double slope = 1;
    if (blend != Blend::kLinear) {
      slope =
          double{SrgbEncode(gray + kStep) - SrgbEncode(gray)} / double{kStep};
    }
    sum += slope * slope * double{sample.variance};
  }
  return std::sqrt(sum / static_cast<double>(samples.size()));
}

}  // namespace rtb
