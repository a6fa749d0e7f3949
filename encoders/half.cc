// Encoder `half`: a lower half block in the colors of two samples. Origin:
// RAYTERM's "pixel mode".
#include <algorithm>
#include <array>
#include <memory>

#include "encoders/encode_cells.h"
#include "encoders/plan_encoder.h"
#include "encoders/registry.h"

namespace rtb {
namespace {

constexpr char32_t kLowerHalf = 0x2584;

Cell EncodeCell(std::span<const Rgb> samples) {
  return {kLowerHalf, Encode8(samples[1]), Encode8(samples[0])};
}

/// The same with vectors, where all of the work is: in the transfer.
void EncodeBatch(std::span<const Rgb> samples, std::span<Cell> cells) {
  constexpr std::size_t kChunk = 64;
  std::array<Rgb8, 2 * kChunk> codes;
  while (!cells.empty()) {
    const std::size_t count = std::min(cells.size(), kChunk);
    Encode8(samples.first(2 * count), std::span(codes).first(2 * count));
    for (std::size_t i = 0; i < count; ++i) {
      cells[i] = {kLowerHalf, codes[2 * i + 1], codes[2 * i]};
    }
    samples = samples.subspan(2 * count);
    cells = cells.subspan(count);
  }
}

class Half : public PlanEncoder {
 public:
  std::vector<char32_t> Candidates() const override { return {U'▄'}; }

  SamplePlan Plan(GridSize grid, double cell_aspect,
                  std::uint64_t /*seed*/) const override {
    return RegularPlan(grid, 1, 2, cell_aspect);
  }

  Result<CellGrid> Encode(const Fragments& fragments,
                          const EncodeContext& context) const override {
    if (context.scalar) {
      return EncodeCells(fragments, 2, context.threads, EncodeCell);
    }
    return EncodeCells(fragments, 2, context.threads, EncodeBatch);
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
