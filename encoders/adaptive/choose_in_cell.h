/// @file
/// ChooseRays' inner loop over the slots of a cell, by vectors. Highway chooses
/// the instruction set at run time; all give the same bits.
#pragma once

#include <cstdint>

#include "encoders/adaptive/slots.h"

namespace rtb {

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
