// Encoder `half`: a lower half block in the colors of two samples. Origin:
// RAYTERM's "pixel mode".
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
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

// A cell is the glyph and then six bytes of codes: red, green and blue of the
// foreground, which is the lower sample, and of the background.
static_assert(sizeof(Cell) == 12 && std::endian::native == std::endian::little);
static_assert(offsetof(Cell, fg) == 4 && offsetof(Cell, bg) == 7);

/// The cell of two samples' codes, two more bytes of which may be read.
void StoreCell(const Rgb8* codes, Cell& cell) {
  std::uint64_t both = 0;
  std::memcpy(&both, codes, sizeof(both));
  constexpr std::uint64_t kColor = 0xffffff;
  const std::uint64_t colors = (both >> 24 & kColor) | (both & kColor) << 24;
  auto* bytes = reinterpret_cast<std::byte*>(&cell);
  std::memcpy(bytes, &kLowerHalf, sizeof(kLowerHalf));
  std::memcpy(bytes + offsetof(Cell, fg), &colors, sizeof(colors));
}

/// The same with vectors, in the transfer.
void EncodeBatch(std::span<const Rgb> samples, std::span<Cell> cells) {
  constexpr std::size_t kChunk = 64;
  std::array<Rgb8, 2 * kChunk + 1> codes;
  while (!cells.empty()) {
    const std::size_t count = std::min(cells.size(), kChunk);
    Encode8(samples.first(2 * count), std::span(codes).first(2 * count));
    for (std::size_t i = 0; i < count; ++i) StoreCell(&codes[2 * i], cells[i]);
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
