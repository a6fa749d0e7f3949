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

/// Sample positions for the cells of a grid. Coordinates inside a cell: u to
/// the right, v down, each in [0, 1). Cells are numbered row by row. An *entry*
/// of a plan is one cell with samples_per_cell samples; a plan asks for every
/// cell once, in order, or for the cells that it lists.
struct SamplePlan {
  GridSize grid;
  double cell_aspect = 0.5;  ///< Cell width / height, as displayed.
  int samples_per_cell = 0;
  /// (u, v) of each sample: `samples_per_cell` of them when all entries have
  /// the same pattern, else entries x samples_per_cell, entry by entry.
  std::vector<V2f> positions;
  /// Width and height, in cells, of the box around each position that the
  /// sample stands for (the support of its box filter).
  V2f footprint{1, 1};
  /// Width and height, in cells, of the beam over which each sample's rays
  /// together average textures: a sub-pixel of the canonical 8 x 16 raster,
  /// whatever the pattern. With the footprint in its place, textures would be
  /// averaged for the encoders, and edges not: they are to differ by how they
  /// sample alone.
  V2f beam{1.0f / 8, 1.0f / 16};
  /// The cells asked for, in any order and as often as needed; empty: all.
  std::vector<int> cells;
  /// For each of `cells` how many samples of that cell were asked for before,
  /// so that each draws random numbers of its own; empty: none.
  std::vector<int> samples_before;

  int entries() const {
    return cells.empty() ? grid.cells() : static_cast<int>(cells.size());
  }
  /// The cell of an entry.
  int cell(int entry) const {
    return cells.empty() ? entry : cells[static_cast<std::size_t>(entry)];
  }
  /// The number of an entry's sample among all of its cell.
  int number(int entry, int sample) const {
    return sample + (samples_before.empty()
                         ? 0
                         : samples_before[static_cast<std::size_t>(entry)]);
  }

  /// True when all entries share one pattern.
  bool uniform() const {
    return positions.size() == static_cast<std::size_t>(samples_per_cell);
  }
  /// Position of one sample of one entry.
  const V2f& position(int entry, int sample) const {
    const std::size_t base =
        uniform() ? 0
                  : static_cast<std::size_t>(entry) *
                        static_cast<std::size_t>(samples_per_cell);
    return positions[base + static_cast<std::size_t>(sample)];
  }
  /// Samples in all.
  std::size_t samples() const {
    return static_cast<std::size_t>(entries()) *
           static_cast<std::size_t>(samples_per_cell);
  }
  /// Width / height of the whole picture.
  double aspect() const { return grid.columns * cell_aspect / grid.rows; }
};

/// The plan of a regular nx x ny pattern of sub-cell centers, row by row; the
/// footprint is 1/nx x 1/ny.
SamplePlan RegularPlan(GridSize grid, int nx, int ny, double cell_aspect = 0.5);

/// The plan of an image: one sample at the center of every pixel, and beams of
/// one pixel.
SamplePlan PixelPlan(int width, int height);

}  // namespace rtb
