/// @file
/// Scores: every metric of a pair of rasters.
#pragma once

#include <nlohmann/json.hpp>

#include "harness/rasters.h"

namespace rtb {

/// All metrics by name, in their list's order; null where undefined.
nlohmann::ordered_json Score(const RasterPair& pair);

}  // namespace rtb
