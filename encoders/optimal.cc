// Encoder `optimal`: for every glyph the two colors of least squared error,
// and of all glyphs the best. In its own space and resolution no other choice
// of a glyph and two colors comes nearer to the samples: the bound that other
// encoders are measured against.
#include <memory>
#include <utility>
#include <vector>

#include "encoders/encode_cells.h"
#include "encoders/fit/atlas_parameters.h"
#include "encoders/fit/batch_fit.h"
#include "encoders/fit/fit.h"
#include "encoders/plan_encoder.h"
#include "encoders/registry.h"

namespace rtb {
namespace {

class Optimal : public PlanEncoder {
 public:
  Optimal(Atlas atlas, Blend blend)
      : atlas_(std::move(atlas)), blend_(blend), batch_(atlas_) {}

  SamplePlan Plan(GridSize grid, double cell_aspect,
                  std::uint64_t /*seed*/) const override {
    return RegularPlan(grid, atlas_.width(), atlas_.height(), cell_aspect);
  }

  Result<CellGrid> Encode(const Fragments& fragments,
                          const EncodeContext& context) const override {
    const int samples = atlas_.width() * atlas_.height();
    if (blend_ == Blend::kSrgb && !context.scalar) {
      return EncodeCells(
          fragments, samples, context.threads,
          [this](std::span<const Rgb> linear, std::span<Cell> cells) {
            batch_.Fit(linear, cells);
          });
    }
    return EncodeCells(
        fragments, samples, context.threads,
        [this](std::span<const Rgb> linear) { return EncodeCell(linear); });
  }

  std::vector<char32_t> Candidates() const override { return atlas_.glyphs(); }

 private:
  Cell EncodeCell(std::span<const Rgb> linear) const {
    std::vector<V3d> samples(linear.size());
    ToBlend(blend_, linear, samples);
    return FitCell(atlas_, blend_, samples).cell;
  }

  Atlas atlas_;
  Blend blend_;
  BatchFit batch_;
};

Result<std::unique_ptr<Encoder>> Make(const EncoderParameters& given) {
  RTB_ASSIGN_OR_RETURN(const Blend blend, ReadBlend(given));
  RTB_ASSIGN_OR_RETURN(Atlas atlas, ReadAtlas(given));
  return std::make_unique<Optimal>(std::move(atlas), blend);
}

}  // namespace

EncoderEntry optimal_entry() {
  std::vector<EncoderParameter> parameters = AtlasParameters();
  parameters.push_back(BlendParameter());
  return {{"optimal", "the glyph and colors of least squared error: the bound",
           128, "space, U+2588 and what `glyphs` names", std::move(parameters)},
          Make};
}

}  // namespace rtb
