/// @file
/// The shape of a decoded cell.
#pragma once

#include "encoders/decode.h"
#include "harness/pixel_size.h"

namespace rtb {

/// The cell of the decoding options.
inline PixelSize CellOf(const DecodeOptions& options) {
  return {options.cell_width, options.cell_height};
}

/// Its width / height.
inline double CellAspect(const DecodeOptions& options) {
  return static_cast<double>(options.cell_width) / options.cell_height;
}

}  // namespace rtb
