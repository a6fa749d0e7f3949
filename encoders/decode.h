/// @file
/// Decoding: what a terminal would show for a grid of cells.
#pragma once

#include <filesystem>

#include "core/base/result.h"
#include "core/image/image.h"
#include "encoders/cell_grid.h"
#include "encoders/glyphs/glyph_set.h"

namespace rtb {

/// How to decode.
struct DecodeOptions {
  int cell_width = 8;    ///< Pixels.
  int cell_height = 16;  ///< Pixels.
  MaskSource masks = MaskSource::kGeometric;
  std::filesystem::path font;  ///< Empty: DejaVu Sans Mono.
  int threads = 0;             ///< Upper bound; 0 = all cores.
};

/// The raster of a grid: sRGB-encoded values in [0, 1]. A pixel that a mask
/// covers partly mixes the cell's two encoded colors by coverage, unrounded.
/// @return an Error when a glyph needs a font that cannot be loaded.
Result<Image> Decode(const CellGrid& grid, const DecodeOptions& options);

}  // namespace rtb
