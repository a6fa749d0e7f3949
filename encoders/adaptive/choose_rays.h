/// @file
/// Where the next rays are worth most. VoronoiMap -> ChooseRays -> SamplePlan.
#pragma once

#include <cstdint>
#include <vector>

#include "encoders/adaptive/choose_in_cells.h"
#include "encoders/adaptive/voronoi_map.h"

namespace rtb {

/// Samples that one cell gets at most.
inline constexpr int kMostPerCell = 64;

/// What the choice of rays depends on.
struct RayRequest {
  int rays = 0;           ///< At most.
  int most_per_cell = 4;  ///< Of these.
  std::uint64_t seed = 0;
  int threads = 0;
};

/// The rays of the largest expected gains, by rising cells. Fewer than asked
/// for only where cells have all that they may get.
std::vector<RayChoice> ChooseRays(const VoronoiMap& map,
                                  const SeenSamples& samples,
                                  const RayRequest& request);

}  // namespace rtb
