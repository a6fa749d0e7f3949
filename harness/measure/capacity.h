/// @file
/// What two colors a cell can show of a raster, glyph by glyph: the sums of
/// least squares that bounds and the encoder's own error are made of.
#pragma once

#include <span>
#include <vector>

#include "core/image/image.h"
#include "encoders/cell_grid.h"
#include "encoders/encoder.h"
#include "encoders/fit/atlas.h"

namespace rtb {

/// The code points that a run could choose: the encoder's candidates, and
/// those that it printed (all that is known of another program's). Rising.
std::vector<char32_t> GlyphsOfRun(const Encoder& encoder, const CellGrid& grid);

/// Mean over pixels and channels of the squared error that is left when each
/// cell shows the best glyph of the atlas in its two best colors, not rounded.
/// @param raster sRGB-encoded values, the atlas' cell size times the grid.
double Capacity(const Image& raster, GridSize grid, const Atlas& atlas,
                int threads);

/// The same when each cell shows the glyph that the grid has there, which the
/// atlas holds.
double CapacityOfMasks(const Image& raster, const CellGrid& grid,
                       const Atlas& atlas, int threads);

}  // namespace rtb
