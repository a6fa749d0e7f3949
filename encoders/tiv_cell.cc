#include "encoders/tiv_cell.h"

#include <algorithm>
#include <array>

#include "encoders/tiv_scalar.h"

namespace rtb {

Cell TivCell(std::span<const Rgb8, kTivPixels> pixels) {
  std::array<std::uint32_t, kTivPixels> packed;
  std::ranges::transform(pixels, packed.begin(), PackedColor);
  return TivCellBy(kTivGlyphs, packed.data());
}

}  // namespace rtb
