/// @file
/// FoundRays: rays to choose the best ones from. RayChooser finds and takes
/// them.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "encoders/adaptive/choose_in_cells.h"
#include "encoders/adaptive/gain_threshold.h"

namespace rtb {

/// Cells take turns, those of the largest gains first: these want many rays,
/// and from what they gain follows how little is too little for others.
inline constexpr std::size_t kTurns = 4;

/// The rays of some cells side by side.
struct FoundRays {
  int begin = 0;  ///< The first of these cells.
  int end = 0;    ///< One past the last.
  /// In the order of finding; those of a cell follow each other, the best
  /// first. Of `rays` the first `count` count.
  std::vector<RayChoice> rays;
  std::size_t count = 0;
  std::size_t known = 0;  ///< So many have been counted.
  /// Where to look for them, turn by turn.
  std::array<std::vector<int>, kTurns> cells;
  std::vector<RayChoice> scratch;  ///< For those of kCellsAtOnce cells.

  std::span<const RayChoice> found() const {
    return std::span(rays).first(count);
  }

  /// Adds those in `scratch`.
  /// @param each places for each cell's.
  /// @param counts as ChooseInCells gives them.
  void Add(std::size_t each, std::span<const int> counts);
};

/// The `count` best rays, or all, by rising cells. Of equal gains those of
/// lower cells, two of each at most unless that is too few or some cell's later
/// ray gains more.
/// @param parts by rising cells.
/// @param threshold has counted all gains that may matter.
std::vector<RayChoice> TakeBest(std::span<const FoundRays> parts, int count,
                                const GainThreshold& threshold);

}  // namespace rtb
