/// @file
/// The inner loops over the slots of a grid, by vectors: VoronoiMap's. Highway
/// chooses the instruction set at run time; all give the same bits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/render/sample_plan.h"
#include "encoders/adaptive/lattice.h"
#include "encoders/adaptive/samples.h"

namespace rtb {

/// The slots of a grid by cells, with a cell more on every side.
struct SlotGrid {
  GridSize grid;
  float cell_width = 0;
  CellSlots* cells = nullptr;
  /// Of each cell, a bit for each slot whose color is new.
  std::uint32_t* changed = nullptr;
  /// Of each cell's blocks, a bound of the squared distances: 0 around the
  /// grid.
  float* farthest = nullptr;
  /// A bound of that in each block and those around it.
  float* around = nullptr;
  float* gains = nullptr;  ///< Of each cell's blocks, the largest gain.

  /// Cells from a row to the next.
  std::ptrdiff_t stride() const { return grid.columns + 2; }
  /// All cells, with those around the grid.
  std::size_t room() const {
    return static_cast<std::size_t>(stride() * (grid.rows + 2));
  }
  /// The place of a cell among them; -1 and one past the last are around.
  std::ptrdiff_t At(int column, int row) const {
    return (row + 1) * stride() + column + 1;
  }
};

/// Gives the slots of a row's cells the nearest samples of a lattice, their
/// only ones, and their number.
/// @param colors of all samples, cell by cell, packed.
void EnterLattice(const Lattice& lattice, std::span<const std::uint32_t> colors,
                  int row, const SlotGrid& slots);

/// Gives the slots that a sample is nearer to than what they have its distance
/// and color, and counts it in its own; later ones come after earlier ones. A
/// sample reaches the blocks around its own.
/// @param first,last the rows of cells to enter into, both included.
void EnterSamples(std::span<const SeenSample> samples, int first, int last,
                  const SlotGrid& slots);

/// The contrasts of the slots of a row's cells that changed or lie beside such,
/// their blocks' `farthest` and `gains`.
/// @param least added to every squared distance of colors.
/// @param root whether the root of that counts.
/// @param best of each cell of the row, the largest gain.
void CompareSlots(const SlotGrid& slots, int row, float least, bool root,
                  float* best);

}  // namespace rtb
