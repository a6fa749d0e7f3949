/// @file
/// The inner loops over slots, by vectors: VoronoiMap's and ChooseRays'.
/// Highway chooses the instruction set at run time; all give the same bits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/render/sample_plan.h"
#include "encoders/adaptive/slots.h"

namespace rtb {

/// The slots of a grid: for each field the kSlots floats of one cell after the
/// other, with a cell more on every side.
struct SlotGrid {
  GridSize grid;
  V2f pitch{0, 0};  ///< From slot to slot.
  float* distance2 = nullptr;
  float* r = nullptr;
  float* g = nullptr;
  float* b = nullptr;
  float* contrast = nullptr;
  float* extent = nullptr;
  /// Of each cell, a bit for each slot whose color is new.
  std::uint32_t* changed = nullptr;

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

/// Gives the slots that a sample is nearer to than what they have its distance
/// and color, and counts it in its own; later ones come after earlier ones.
/// @param reaches see VoronoiMap::Insert.
/// @param first,last the rows of cells to enter into, both included.
void EnterSamples(std::span<const SeenSample> samples,
                  std::span<const float> reaches, int first, int last,
                  const SlotGrid& slots);

/// The contrasts of the slots of a row's cells that changed or lie beside such,
/// and their cells' best gains.
/// @param least added to every squared contrast.
/// @param root whether its root counts.
/// @param best of each cell of the row.
void CompareSlots(const SlotGrid& slots, int row, float least, bool root,
                  float* best);

}  // namespace rtb
