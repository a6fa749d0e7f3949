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

/// The same for any number of cells, whose samples stand one cell after the
/// other.
using CellsEncoder =
    std::function<void(std::span<const Rgb> samples, std::span<Cell> cells)>;

/// Encodes every cell by itself, on at most `threads` threads (0 = all).
/// Checks that the fragments have `samples` samples a cell.
CellGrid EncodeCells(const Fragments& fragments, int samples, int threads,
                     const CellEncoder& encode);

/// The same, batches of cells at a time.
CellGrid EncodeCells(const Fragments& fragments, int samples, int threads,
                     const CellsEncoder& encode);

}  // namespace rtb
