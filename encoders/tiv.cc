// Encoder `tiv`: exactly what TerminalImageViewer 1.3 computes with its
// default options and 24-bit colors from the same 4 x 8 8-bit pixels. Its
// direct mode costs quality on clean renders; it is kept exact nevertheless.
#include <algorithm>
#include <array>
#include <memory>

#include "encoders/encode_cells.h"
#include "encoders/plan_encoder.h"
#include "encoders/registry.h"
#include "encoders/simd/kernels.h"
#include "encoders/tiv_cell.h"

namespace rtb {
namespace {

Cell EncodeCell(std::span<const Rgb> linear) {
  std::array<Rgb8, kTivPixels> pixels;
  std::ranges::transform(linear, pixels.begin(),
                         [](const Rgb& color) { return Encode8(color); });
  return TivCell(pixels);
}

/// The same with vectors.
void EncodeBatch(std::span<const Rgb> linear, std::span<Cell> cells) {
  constexpr std::size_t kChunk = 16;
  std::array<Rgb8, kTivPixels * kChunk> buffer;
  while (!cells.empty()) {
    const std::size_t count = std::min(cells.size(), kChunk);
    const auto pixels = std::span(buffer).first(kTivPixels * count);
    Encode8(linear.first(pixels.size()), pixels);
    EncodeTivCells(pixels, cells.first(count));
    linear = linear.subspan(pixels.size());
    cells = cells.subspan(count);
  }
}

class Tiv : public PlanEncoder {
 public:
  std::vector<char32_t> Candidates() const override {
    std::vector<char32_t> glyphs;
    for (const TivGlyph& glyph : kTivGlyphs) glyphs.push_back(glyph.code_point);
    return glyphs;
  }

  SamplePlan Plan(GridSize grid, double cell_aspect,
                  std::uint64_t /*seed*/) const override {
    return RegularPlan(grid, kTivColumns, kTivRows, cell_aspect);
  }

  Result<CellGrid> Encode(const Fragments& fragments,
                          const EncodeContext& context) const override {
    if (context.scalar) {
      return EncodeCells(fragments, kTivPixels, context.threads, EncodeCell);
    }
    return EncodeCells(fragments, kTivPixels, context.threads, EncodeBatch);
  }
};

Result<std::unique_ptr<Encoder>> Make(const EncoderParameters& /*given*/) {
  return std::make_unique<Tiv>();
}

}  // namespace

EncoderEntry tiv_entry() {
  return {{"tiv",
           "what TerminalImageViewer 1.3 chooses, cell for cell",
           kTivPixels,
           "U+00A0, U+2581-2587, U+258A, U+258C, U+258E, U+2596-2598, U+259A, "
           "U+259D and box drawing",
           {}},
          Make};
}

}  // namespace rtb
