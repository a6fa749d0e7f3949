/// @file
/// ChooseRays' inner loop over the slots of cells, by vectors. Highway chooses
/// the instruction set at run time; all give the same bits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "encoders/adaptive/slots.h"

namespace rtb {

/// Cells that rays are chosen in at once, at most.
inline constexpr std::size_t kCellsAtOnce = 64;

/// A cell to choose rays in.
struct CellChoice {
  const CellSlots* slots = nullptr;
  int cell = 0;
  int seen = 0;  ///< Samples that it has.
  int most = 1;  ///< New ones at most, at least 1.
};

/// What holds for all cells.
struct ChoiceTerms {
  float cell_width = 0;
  float least = 0;  ///< What each ray has to gain.
  std::uint64_t seed = 0;
};

/// A ray that is to be traced.
struct RayChoice {
  int cell = 0;
  V2f position{0, 0};  ///< Inside the cell, in [0, 1).
  float gain = 0;      ///< By which rays are compared.
};

/// The best rays of cells, in each one at a time: it counts as a sample, whose
/// color is not known, before the next is chosen. Of equal slots the first.
/// @param cells kCellsAtOnce at most.
/// @param room places for each cell's rays, at least as many as any `most`.
/// @param out the n-th cell's from n x room on.
/// @param counts how many, for each cell.
void ChooseInCells(std::span<const CellChoice> cells, const ChoiceTerms& terms,
                   std::size_t room, RayChoice* out, int* counts);

}  // namespace rtb
