/// @file
/// Lattice: samples at the same places in every cell. Its Voronoi diagram is
/// that of one cell, over and over. SeenSamples -> Lattice -> VoronoiMap.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "encoders/adaptive/slots.h"

namespace rtb {

/// A sample of a cell or of one around it.
struct LatticeSample {
  int column = 0, row = 0;  ///< Of its cell, from the cell that it is seen in.
  std::size_t number = 0;   ///< Among that cell's.
  std::array<float, kSlots> distance2{};  ///< From the slots, squared.
};

/// The samples that slots of a cell may be nearest to.
struct Lattice {
  /// @param positions inside the cells.
  Lattice(std::span<const V2f> positions, float cell_width);

  std::size_t per_cell;
  std::array<std::uint8_t, kSlots> samples{};  ///< In each slot.
  std::vector<LatticeSample> around;  ///< All of up to 9 cells, in order.
  /// Of these the nearest ones, for cells with others on every side.
  std::vector<LatticeSample> nearest;
};

}  // namespace rtb
