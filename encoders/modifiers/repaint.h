/// @file
/// Repainting: glyph and colors of every cell chosen anew by least squares,
/// among the encoder's own glyphs, for a terminal's palette or with the masks
/// of a font.
#pragma once

#include <cstdint>

#include "encoders/cell_grid.h"
#include "encoders/color_depth.h"
#include "encoders/fit/atlas.h"
#include "encoders/modifiers/modifiers.h"
#include "encoders/modifiers/raster.h"

namespace rtb {

/// What repainting depends on beside the samples.
struct RepaintOptions {
  ColorDepth depth = ColorDepth::kTruecolor;
  Dither dither = Dither::kNone;
  Blend blend = Blend::kSrgb;
  std::uint64_t seed = 0;
  int threads = 0;
};

/// The cells of least squared error against the (dithered) samples.
/// @param atlas candidates in masks of the raster's size.
CellGrid Repaint(SampleRaster raster, const Atlas& atlas,
                 const RepaintOptions& options);

/// Whether every color that shows is one of the depth's.
bool FitsDepth(const CellGrid& grid, ColorDepth depth);

}  // namespace rtb
