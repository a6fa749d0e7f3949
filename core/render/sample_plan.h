/// @file
/// SamplePlan: where in each cell of a grid samples are wanted. Encoders make
/// plans, FragmentSources answer them with Fragments.
#pragma once

#include <cstddef>
#include <vector>

#include "core/math/vec.h"

namespace rtb {

/// A grid of character cells (or of pixels): columns x rows, rows downwards.
struct GridSize {
  int columns = 0;
  int rows = 0;
  int cells() const { return columns * rows; }
  bool operator==(const GridSize&) const = default;
};

/// Sample positions for every cell of a grid. Coordinates inside a cell: u to
/// the right, v down, each in [0, 1). Cells are numbered row by row.
struct SamplePlan {
  GridSize grid;
  double cell_aspect = 0.5;  ///< Cell width / height, as displayed.
  int samples_per_cell = 0;
  /// (u, v) of each sample: `samples_per_cell` entries when every cell has the
  /// same pattern, else cells x samples_per_cell, cell by cell.
  std::vector<V2f> positions;
  /// Width and height, in cells, of the box around each position that the
  /// sample stands for (the support of its box filter).
  V2f footprint{1, 1};

  /// True when all cells share one pattern.
  bool uniform() const {
    return positions.size() == static_cast<std::size_t>(samples_per_cell);
  }
  /// Position of one sample of one cell.
  const V2f& position(int cell, int sample) const {
    const std::size_t base =
        uniform() ? 0
                  : static_cast<std::size_t>(cell) *
                        static_cast<std::size_t>(samples_per_cell);
    return positions[base + static_cast<std::size_t>(sample)];
  }
  /// Width / height of the whole picture.
  double aspect() const { return grid.columns * cell_aspect / grid.rows; }
};

/// The plan of a regular nx x ny pattern of sub-cell centers, row by row; the
/// footprint is 1/nx x 1/ny.
SamplePlan RegularPlan(GridSize grid, int nx, int ny, double cell_aspect = 0.5);

/// The plan of an image: one sample at the center of every pixel.
SamplePlan PixelPlan(int width, int height);

}  // namespace rtb
