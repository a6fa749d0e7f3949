#include "encoders/mosaic.h"

#include <array>

#include "encoders/encode_cells.h"
#include "encoders/glyphs/patterns.h"
#include "encoders/partition.h"
#include "encoders/plan_encoder.h"

namespace rtb {
namespace {

constexpr int kColumns = 2;
constexpr int kMaxRows = 4;

class Mosaic : public PlanEncoder {
 public:
  Mosaic(const MosaicKind& kind, Blend blend) : kind_(kind), blend_(blend) {}

  std::vector<char32_t> Candidates() const override {
    return GlyphsOfPatterns(kind_.glyph, kColumns * kind_.rows);
  }

  SamplePlan Plan(GridSize grid, double cell_aspect,
                  std::uint64_t /*seed*/) const override {
    return RegularPlan(grid, kColumns, kind_.rows, cell_aspect);
  }

  Result<CellGrid> Encode(const Fragments& fragments,
                          const EncodeContext& context) const override {
    return EncodeCells(
        fragments, kColumns * kind_.rows, context.threads,
        [this](std::span<const Rgb> linear) { return EncodeCell(linear); });
  }

 private:
  Cell EncodeCell(std::span<const Rgb> linear) const {
    std::array<V3d, kColumns * kMaxRows> buffer;
    const auto samples = std::span(buffer).first(linear.size());
    ToBlend(blend_, linear, samples);
    const SampleMask on = BrighterSide(blend_, samples, BestPartition(samples));
    return CellOfMeans(blend_, samples, on, kind_.glyph(on));
  }

  MosaicKind kind_;
  Blend blend_;
};

}  // namespace

Result<std::unique_ptr<Encoder>> MakeMosaic(const MosaicKind& kind,
                                            const EncoderParameters& given) {
  RTB_ASSIGN_OR_RETURN(const Blend blend, ReadBlend(given));
  return std::make_unique<Mosaic>(kind, blend);
}

}  // namespace rtb
