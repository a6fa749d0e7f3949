#include "tests/encoders/glyphs/mask_text.h"

#include <cmath>

#include "core/base/check.h"

namespace rtb {
namespace {

/// One row of a mask: ' ' 0, '#' 1, else the coverage in tenths.
std::string RowText(const Mask& mask, int y) {
  std::string text;
  for (int x = 0; x < mask.width; ++x) {
    const float coverage = mask.at(x, y);
    if (coverage == 0) {
      text += '.';
    } else if (coverage == 1) {
      text += '#';
    } else {
      text += static_cast<char>('0' + std::lround(coverage * 10));
    }
  }
  return text + "\n";
}

}  // namespace

Mask MaskOf(char32_t glyph, int width, int height) {
  const auto shape = ShapeOf(glyph);
  RTB_CHECK(shape.has_value());
  return RasterizeShape(*shape, width, height);
}

std::string Text(const Mask& mask) {
  std::string text;
  for (int y = 0; y < mask.height; ++y) text += RowText(mask, y);
  return text;
}

}  // namespace rtb
