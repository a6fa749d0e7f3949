#include "encoders/modifiers/sampled_masks.h"

#include <algorithm>

namespace rtb {
namespace {

/// Sub-pixels of the masks that footprints are measured on: halves, thirds,
/// quarters and eighths of the cell end between two of them.
constexpr int kFineWidth = 24;
constexpr int kFineHeight = 48;

/// Length that [begin, end) shares with [index, index + 1).
double Overlap(double begin, double end, int index) {
  return std::max(0.0,
                  std::min(end, index + 1.0) - std::max(begin, 0.0 + index));
}

/// Sub-pixels of one axis that a footprint touches.
struct Range {
  double begin, end;
  int first, last;

  Range(float center, float size, int count)
      : begin(std::clamp((center - 0.5 * size) * count, 0.0, 1.0 * count)),
        end(std::clamp((center + 0.5 * size) * count, 0.0, 1.0 * count)),
        first(std::min(static_cast<int>(begin), count - 1)),
        last(std::min(static_cast<int>(end), count - 1)) {}
};

/// Mean coverage over the part of a footprint that lies in the cell.
float CoverageOf(const Mask& mask, const CellSample& sample) {
  const Range x(sample.position.x, sample.footprint.x, mask.width);
  const Range y(sample.position.y, sample.footprint.y, mask.height);
  double area = 0;
  double covered = 0;
  for (int row = y.first; row <= y.last; ++row) {
    for (int column = x.first; column <= x.last; ++column) {
      const double part =
          Overlap(x.begin, x.end, column) * Overlap(y.begin, y.end, row);
      area += part;
      covered += part * mask.at(column, row);
    }
  }
  return area > 0 ? static_cast<float>(covered / area)
                  : mask.at(x.first, y.first);
}

bool AllCellsAlike(const Evidence& evidence) {
  return evidence.rounds.size() == 1 && evidence.rounds[0].plan.uniform() &&
         evidence.rounds[0].plan.cells.empty();
}

}  // namespace

Result<SampledMasks> SampledMasks::Make(
    const Evidence& evidence, const SamplesByCell& samples,
    const std::map<char32_t, char32_t>& glyphs,
    const std::optional<std::filesystem::path>& font) {
  SampledMasks masks(samples);
  masks.shared_ = AllCellsAlike(evidence);
  GlyphSet set(kFineWidth, kFineHeight,
               font ? MaskSource::kFont : MaskSource::kGeometric,
               font.value_or(std::filesystem::path()));
  for (const auto& [glyph, covering] : glyphs) {
    RTB_ASSIGN_OR_RETURN(const Mask* const mask, set.Get(covering));
    masks.fine_.emplace(glyph, *mask);
    if (masks.shared_) masks.masks_.emplace(glyph, masks.Build(glyph, 0));
  }
  return masks;
}

const FitMask& SampledMasks::Of(char32_t glyph, int cell,
                                FitMask& storage) const {
  if (shared_) return masks_.at(glyph);
  storage = Build(glyph, cell);
  return storage;
}

FitMask SampledMasks::Build(char32_t glyph, int cell) const {
  const auto samples = samples_.cell(cell);
  Mask mask(static_cast<int>(samples.size()), 1);
  std::ranges::transform(samples, mask.coverage.begin(),
                         [&fine = fine_.at(glyph)](const CellSample& sample) {
                           return CoverageOf(fine, sample);
                         });
  return MakeFitMask(glyph, mask);
}

}  // namespace rtb
