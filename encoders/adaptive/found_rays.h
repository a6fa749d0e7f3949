/// @file
/// FoundRays: rays to choose the best ones from. ChooseRays finds and takes
/// them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "encoders/adaptive/choose_in_cell.h"
#include "encoders/adaptive/gain_threshold.h"

namespace rtb {

/// The rays of some cells side by side.
struct FoundRays {
  std::vector<RayChoice> rays;    ///< In the order of finding.
  std::vector<std::uint32_t> at;  ///< Of each cell, where its first one is.
  std::vector<std::uint8_t> counts;
  std::size_t known = 0;  ///< So many have been counted.

  /// Whether a ray is the n-th or a later one of its cell.
  bool IsLater(std::size_t i, std::size_t n) const {
    return i >= n && rays[i - n].cell == rays[i].cell;
  }
};

/// The `count` best rays, or all, by rising cells. Of equal gains those of
/// lower cells, two of each at most unless that is too few.
/// @param threshold has counted all gains that may matter.
std::vector<RayChoice> TakeBest(std::span<const FoundRays> parts, int count,
                                const GainThreshold& threshold);

}  // namespace rtb
