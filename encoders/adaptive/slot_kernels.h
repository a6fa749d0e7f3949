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

/// A cell to choose rays in.
struct CellChoice {
  const float* contrast = nullptr;   ///< As CellSlots.
  const float* distance2 = nullptr;  ///< As CellSlots.
  const float* extent = nullptr;     ///< As CellSlots.
  float cell_width = 0;
  int cell = 0;
  int seen = 0;     ///< Samples that it has.
  int most = 0;     ///< New ones at most.
  float least = 0;  ///< What each has to gain.
  std::uint64_t seed = 0;
};

/// A ray that is to be traced.
struct RayChoice {
  int cell = 0;
  V2f position{0, 0};  ///< Inside the cell, in [0, 1).
  float gain = 0;      ///< By which rays are compared.
  float reach = 0;     ///< How far away slots may be nearest to it.
};

/// The best rays of a cell, one at a time: each counts as a sample, whose color
/// is not known, before the next is chosen. Of equal slots the first.
/// @param out room for `most`.
/// @return how many.
int ChooseInCell(const CellChoice& choice, RayChoice* out);

}  // namespace rtb
