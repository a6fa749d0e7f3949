// The encoder around an encoder.
#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "core/base/parallel.h"
#include "encoders/modifiers/judge.h"
#include "encoders/modifiers/modifiers.h"
#include "encoders/modifiers/repaint.h"
#include "encoders/modifiers/sampled_masks.h"

namespace rtb {
namespace {

constexpr int kGrain = 64;

/// Adds what the dark side of solid and half blocks needs when both colors are
/// given: the complements of those that are there.
void AddComplements(std::set<char32_t>& glyphs) {
  constexpr std::pair<char32_t, char32_t> kPairs[] = {{0x2580, 0x2584},
                                                      {0x258C, 0x2590}};
  for (const auto& [one, other] : kPairs) {
    if (!glyphs.contains(one) && !glyphs.contains(other)) continue;
    glyphs.insert({one, other});
  }
  glyphs.insert({U' ', kFullBlock});
}

class Modified : public Encoder {
 public:
  Modified(std::unique_ptr<Encoder> encoder, Modifiers modifiers)
      : encoder_(std::move(encoder)), modifiers_(std::move(modifiers)) {}

  std::vector<char32_t> Candidates() const override {
    return encoder_->Candidates();
  }
  char32_t ChosenAs(char32_t glyph) const override {
    // A font's coverage is asked for by name.
    return modifiers_.atlas ? glyph : encoder_->ChosenAs(glyph);
  }

  Result<Encoding> Run(FragmentSource& source, GridSize grid,
                       double cell_aspect,
                       const EncodeContext& context) const override {
    RTB_ASSIGN_OR_RETURN(Encoding encoding,
                         encoder_->Run(source, grid, cell_aspect, context));
    if (modifiers_.atlas || !FitsDepth(encoding.grid, context.depth)) {
      RTB_RETURN_IF_ERROR(RepaintCells(context, encoding));
    }
    const CellGrid* const last = LastFrame(encoding.grid.size, context);
    const bool median = modifiers_.color == ColorRule::kMedian;
    if (median || last != nullptr) {
      RTB_RETURN_IF_ERROR(JudgeCells(context, last, encoding));
    }
    return encoding;
  }

 private:
  /// The last frame, where its cells may be kept.
  const CellGrid* LastFrame(GridSize size, const EncodeContext& context) const {
    const bool usable = modifiers_.temporal > 0 &&
                        context.previous != nullptr &&
                        context.previous->size == size &&
                        FitsDepth(*context.previous, context.depth);
    return usable ? context.previous : nullptr;
  }

  /// Glyphs that may be chosen, by rising code point.
  std::vector<char32_t> GlyphsFor(const CellGrid& grid,
                                  ColorDepth depth) const {
    const std::vector<char32_t> candidates = encoder_->Candidates();
    std::set<char32_t> glyphs(candidates.begin(), candidates.end());
    if (candidates.empty()) {
      for (const Cell& cell : grid.cells) glyphs.insert(cell.glyph);
    }
    if (depth == ColorDepth::kMono) AddComplements(glyphs);
    return {glyphs.begin(), glyphs.end()};
  }

  Result<Atlas> AtlasFor(const CellGrid& grid, ColorDepth depth, int width,
                         int height) const {
    const std::vector<char32_t> glyphs = GlyphsFor(grid, depth);
    if (!modifiers_.atlas) return MakeAtlas(glyphs, width, height);
    return MakeAtlas(glyphs, width, height, MaskSource::kFont,
                     *modifiers_.atlas);
  }

  Status RepaintCells(const EncodeContext& context, Encoding& encoding) const {
    SampleRaster raster =
        RasterOf(encoding.evidence, modifiers_.blend, context.threads);
    RTB_ASSIGN_OR_RETURN(
        const Atlas atlas,
        AtlasFor(encoding.grid, context.depth, raster.width, raster.height));
    encoding.grid = Repaint(std::move(raster), atlas,
                            {context.depth, modifiers_.dither, modifiers_.blend,
                             context.seed, context.threads});
    return {};
  }

  /// Median colors, and the last frame's cells where they may stay.
  Status JudgeCells(const EncodeContext& context, const CellGrid* last,
                    Encoding& encoding) const {
    const SamplesByCell samples(encoding.evidence);
    std::map<char32_t, char32_t> glyphs;
    const auto add = [&](const CellGrid& grid) {
      for (const Cell& cell : grid.cells) {
        glyphs.emplace(cell.glyph, ChosenAs(cell.glyph));
      }
    };
    add(encoding.grid);
    if (last != nullptr) add(*last);
    RTB_ASSIGN_OR_RETURN(const SampledMasks masks,
                         SampledMasks::Make(encoding.evidence, samples, glyphs,
                                            modifiers_.atlas));
    RTB_ASSIGN_OR_RETURN(const double partitions,
                         Partitions(encoding.grid, context.depth));
    const CellJudge judge({modifiers_, context.depth, encoding.evidence.weight,
                           encoding.evidence.noise, partitions},
                          samples, masks);
    const std::vector<bool> drifted = DriftOf(judge, encoding.grid, last);
    ParallelFor(encoding.grid.size.cells(), kGrain, context.threads,
                [&](int begin, int end) {
                  for (int i = begin; i < end; ++i) {
                    const auto at = static_cast<std::size_t>(i);
                    Cell& cell = encoding.grid.cells[at];
                    cell =
                        judge.Choose(i, cell, last ? &last->cells[at] : nullptr,
                                     drifted[at]);
                  }
                });
    return {};
  }

  /// Where the picture has moved; nowhere without a last frame.
  static std::vector<bool> DriftOf(const CellJudge& judge, const CellGrid& grid,
                                   const CellGrid* last) {
    if (last == nullptr) return std::vector<bool>(grid.cells.size());
    std::vector<MeanChange> changes;
    for (std::size_t i = 0; i < grid.cells.size(); ++i) {
      changes.push_back(
          judge.ChangeOf(static_cast<int>(i), grid.cells[i], last->cells[i]));
    }
    return FindDrift(grid.size, changes);
  }

  /// Masks to choose from; of two complementary ones the first counts.
  Result<double> Partitions(const CellGrid& grid, ColorDepth depth) const {
    constexpr int kWidth = 8;
    constexpr int kHeight = 16;
    RTB_ASSIGN_OR_RETURN(const Atlas atlas,
                         AtlasFor(grid, depth, kWidth, kHeight));
    return static_cast<double>(
        std::ranges::count(atlas.candidates(), -1, &FitMask::complement));
  }

  std::unique_ptr<Encoder> encoder_;
  Modifiers modifiers_;
};

}  // namespace

std::unique_ptr<Encoder> MakeModified(std::unique_ptr<Encoder> encoder,
                                      const Modifiers& modifiers) {
  return std::make_unique<Modified>(std::move(encoder), modifiers);
}

}  // namespace rtb
