// Encoder `half`: a lower half block in the colors of two samples. Origin:
// RAYTERM's "pixel mode".
#include <memory>

#include "encoders/encode_cells.h"
#include "encoders/plan_encoder.h"
#include "encoders/registry.h"

namespace rtb {
namespace {

constexpr char32_t kLowerHalf = 0x2584;

class Half : public PlanEncoder {
 public:
  SamplePlan Plan(GridSize grid, double cell_aspect,
                  std::uint64_t /*seed*/) const override {
    return RegularPlan(grid, 1, 2, cell_aspect);
  }

  Result<CellGrid> Encode(const Fragments& fragments,
                          const EncodeContext& context) const override {
    return EncodeCells(
        fragments, 2, context.threads, [](std::span<const Rgb> samples) {
          return Cell{kLowerHalf, Encode8(samples[1]), Encode8(samples[0])};
        });
  }
};

Result<std::unique_ptr<Encoder>> Make(const EncoderParameters& /*given*/) {
  return std::make_unique<Half>();
}

}  // namespace

EncoderEntry half_entry() {
  return {{"half",
           "lower half blocks in the colors of two samples",
           2,
           "U+2584",
           {}},
          Make};
}

}  // namespace rtb
