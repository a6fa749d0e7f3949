/// @file
/// Encodes grids by the best partition of each cell's samples.
#pragma once

#include <span>

#include "core/render/fragments.h"
#include "encoders/blend.h"
#include "encoders/cell_grid.h"
#include "encoders/encoder.h"

namespace rtb {

/// BestPartitionCell (partition.h) of every cell, by vectors where the blend
/// space is sRGB and the context allows it. `glyphs` has one for each set of
/// "on" samples: 16, 64 or 256 for 4, 6 or 8 samples a cell.
CellGrid EncodePartitionGrid(const Fragments& fragments,
                             std::span<const char32_t> glyphs, Blend blend,
                             const EncodeContext& context);

}  // namespace rtb
