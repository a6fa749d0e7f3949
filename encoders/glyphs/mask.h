/// @file
/// Mask: how much of each sub-pixel of a cell a glyph covers.
#pragma once

#include <cstddef>
#include <vector>

#include "encoders/glyphs/shape.h"

namespace rtb {

/// width x height coverages in [0, 1], row by row from the top left.
struct Mask {
  int width = 0;
  int height = 0;
  std::vector<float> coverage;

  /// Nothing covered.
  Mask(int mask_width, int mask_height)
      : width(mask_width),
        height(mask_height),
        coverage(static_cast<std::size_t>(mask_width) *
                 static_cast<std::size_t>(mask_height)) {}

  float& at(int x, int y) {
    return coverage[static_cast<std::size_t>(y * width + x)];
  }
  float at(int x, int y) const {
    return coverage[static_cast<std::size_t>(y * width + x)];
  }
};

/// The exact area that a shape covers of each sub-pixel.
Mask RasterizeShape(const GlyphShape& shape, int width, int height);

}  // namespace rtb
