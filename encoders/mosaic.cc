#include "encoders/mosaic.h"

#include <unordered_map>
#include <vector>

#include "encoders/encode_partitions.h"
#include "encoders/plan_encoder.h"

namespace rtb {
namespace {

constexpr int kColumns = 2;

class Mosaic : public PlanEncoder {
 public:
  Mosaic(const MosaicKind& kind, Blend blend)
      : rows_(kind.rows), blend_(blend) {
    const unsigned patterns = 1u << (kColumns * rows_);
    for (unsigned i = 0; i < patterns; ++i) {
      glyphs_.push_back(kind.glyph(i));
      if (kind.filling != nullptr) {
        filling_.emplace(kind.glyph(i), kind.filling(i));
      }
    }
  }

  std::vector<char32_t> Candidates() const override { return glyphs_; }

  char32_t ChosenAs(char32_t glyph) const override {
    const auto found = filling_.find(glyph);
    return found == filling_.end() ? glyph : found->second;
  }

  SamplePlan Plan(GridSize grid, double cell_aspect,
                  std::uint64_t /*seed*/) const override {
    return RegularPlan(grid, kColumns, rows_, cell_aspect);
  }

  Result<CellGrid> Encode(const Fragments& fragments,
                          const EncodeContext& context) const override {
    return EncodePartitionGrid(fragments, glyphs_, blend_, context);
  }

 private:
  int rows_;
  Blend blend_;
  std::vector<char32_t> glyphs_;  ///< Of each pattern.
  std::unordered_map<char32_t, char32_t> filling_;
};

}  // namespace

Result<std::unique_ptr<Encoder>> MakeMosaic(const MosaicKind& kind,
                                            const EncoderParameters& given) {
  RTB_ASSIGN_OR_RETURN(const Blend blend, ReadBlend(given));
  return std::make_unique<Mosaic>(kind, blend);
}

}  // namespace rtb
