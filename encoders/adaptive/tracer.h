/// @file
/// Tracing a picture in rounds that learn from each other. FragmentSource ->
/// TraceAdaptively -> SeenSamples.
#pragma once

#include <cstdint>

#include "core/base/result.h"
#include "core/render/fragment_source.h"
#include "encoders/adaptive/voronoi_map.h"

namespace rtb {

/// What is traced.
struct TraceRequest {
  GridSize grid;
  double cell_aspect = 0.5;
  double rays = 8;  ///< At most, mean over the cells; at least 1.
  Priority priority = Priority::kSquare;
  std::uint64_t seed = 0;
  int threads = 0;
};

/// One or two rays in every cell, then the rest of the budget where it pays.
/// @return the source's errors.
Result<SeenSamples> TraceAdaptively(FragmentSource& source,
                                    const TraceRequest& request);

}  // namespace rtb
