// Encoder `example`: two samples side by side, drawn with a half block. It is
// what docs/adding-an-encoder.md walks through; as an encoder of its own it
// would be encoders/example.cc.
#include "tests/encoders/example_encoder.h"

#include <memory>

#include "encoders/encode_cells.h"
#include "encoders/parameters.h"
#include "encoders/plan_encoder.h"

namespace rtb {
namespace {

/// In the order of the parameter's values.
enum class Side { kLeft, kRight };

const EncoderParameter& SideParameter() {
  static const EncoderParameter parameter{"side", "left", "left|right",
                                          "the half that the foreground fills"};
  return parameter;
}

class Example : public PlanEncoder {
 public:
  explicit Example(Side side) : side_(side) {}

  SamplePlan Plan(GridSize grid, double cell_aspect,
                  std::uint64_t /*seed*/) const override {
    return RegularPlan(grid, 2, 1, cell_aspect);
  }

  Result<CellGrid> Encode(const Fragments& fragments,
                          const EncodeContext& context) const override {
    return EncodeCells(
        fragments, 2, context.threads, [this](std::span<const Rgb> samples) {
          return EncodeCell(Encode8(samples[0]), Encode8(samples[1]));
        });
  }

 private:
  Cell EncodeCell(Rgb8 left, Rgb8 right) const {
    if (side_ == Side::kLeft) return {U'▌', left, right};
    return {U'▐', right, left};
  }

  Side side_;
};

Result<std::unique_ptr<Encoder>> Make(const EncoderParameters& given) {
  RTB_ASSIGN_OR_RETURN(const int side, ReadChoice(SideParameter(), given));
  return std::make_unique<Example>(static_cast<Side>(side));
}

}  // namespace

EncoderEntry example_entry() {
  return {{"example",
           "half blocks in the colors of two samples side by side",
           2,
           "U+258C or U+2590",
           {SideParameter()}},
          Make};
}

}  // namespace rtb
