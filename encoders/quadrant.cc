// Encoder `quadrant`: 2 x 2 samples, each in one of two colors. Origin:
// RAYTERM's "Quadrant Algorithm".
#include <array>
#include <memory>

#include "encoders/encode_cells.h"
#include "encoders/encode_partitions.h"
#include "encoders/glyphs/patterns.h"
#include "encoders/plan_encoder.h"
#include "encoders/quadrant_split.h"
#include "encoders/registry.h"
#include "encoders/simd/kernels.h"

namespace rtb {
namespace {

constexpr int kSamples = kQuadrants;

/// In the order of the parameter's values.
enum class Split { kBrightness, kRange, kBest };

const EncoderParameter& SplitParameter() {
  static const EncoderParameter parameter{
      "split", "brightness", "brightness|range|best",
      "what decides which quadrants are on: brightness above the mean, the "
      "channel of the largest range above its middle, or the least squared "
      "error"};
  return parameter;
}

class Quadrant : public PlanEncoder {
 public:
  Quadrant(Split split, Blend blend) : split_(split), blend_(blend) {
    for (unsigned i = 0; i < glyphs_.size(); ++i) glyphs_[i] = QuadrantGlyph(i);
  }

  std::vector<char32_t> Candidates() const override {
    return GlyphsOfPatterns(QuadrantGlyph, kSamples);
  }

  SamplePlan Plan(GridSize grid, double cell_aspect,
                  std::uint64_t /*seed*/) const override {
    return RegularPlan(grid, 2, 2, cell_aspect);
  }

  Result<CellGrid> Encode(const Fragments& fragments,
                          const EncodeContext& context) const override {
    if (split_ == Split::kBest) {
      return EncodePartitionGrid(fragments, glyphs_, blend_, context);
    }
    const auto split =
        split_ == Split::kRange ? RangeSplitCell : BrightnessSplitCell;
    if (context.scalar || split_ == Split::kRange || blend_ != Blend::kSrgb) {
      return EncodeCells(fragments, kSamples, context.threads,
                         [&](std::span<const Rgb> linear) {
                           return split(blend_, linear, glyphs_);
                         });
    }
    return EncodeCells(fragments, kSamples, context.threads,
                       [&](std::span<const Rgb> linear, std::span<Cell> cells) {
                         EncodeBrightnessSplits(linear, glyphs_, cells);
                       });
  }

 private:
  Split split_;
  Blend blend_;
  std::array<char32_t, 1 << kSamples> glyphs_;
};

Result<std::unique_ptr<Encoder>> Make(const EncoderParameters& given) {
  RTB_ASSIGN_OR_RETURN(const int split, ReadChoice(SplitParameter(), given));
  RTB_ASSIGN_OR_RETURN(const Blend blend, ReadBlend(given));
  return std::make_unique<Quadrant>(static_cast<Split>(split), blend);
}

}  // namespace

EncoderEntry quadrant_entry() {
  return {{"quadrant",
           "quadrants above and below a threshold, in two colors",
           kSamples,
           "space, U+2580, U+2584, U+258C, U+2590, U+2596-259F",
           {SplitParameter(), BlendParameter()}},
          Make};
}

}  // namespace rtb
