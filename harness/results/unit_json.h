/// @file
/// The JSON form of a unit of work and of its failure.
///
/// The readers throw nlohmann's exceptions; ParseRecord catches them.
#pragma once

#include "harness/results/failure.h"
#include "harness/results/json.h"
#include "harness/results/unit.h"

namespace rtb {

Json ToJson(const Unit& unit);
Json ToJson(const RunFailure& failure);  ///< Without an empty encoder.
Unit ToUnit(const Json& json);
RunFailure ToFailure(const Json& json);

}  // namespace rtb
