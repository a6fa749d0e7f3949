/// @file
/// The loop over cells that most encoders share.
#pragma once

#include <functional>
#include <span>

#include "core/render/fragments.h"
#include "encoders/cell_grid.h"

namespace rtb {

/// Chooses the cell for the samples of one cell (linear, unclipped). Called
/// from several threads at once.
using CellEncoder = std::function<Cell(std::span<const Rgb> samples)>;

/// Encodes every cell by itself, on at most `threads` threads (0 = all).
/// Checks that the fragments have `samples` samples a cell.
CellGrid EncodeCells(const Fragments& fragments, int samples, int threads,
                     const CellEncoder& encode);

}  // namespace rtb
