/// @file
/// The JSON form of the measures that a run may carry beside its metrics.
///
/// The readers throw nlohmann's exceptions; ParseRecord catches them.
#pragma once

#include <optional>

#include "core/render/ray_counts.h"
#include "harness/results/bound.h"
#include "harness/results/decomposition.h"
#include "harness/results/json.h"
#include "harness/results/live_result.h"
#include "harness/results/pictures.h"
#include "harness/results/temporal_result.h"

namespace rtb {

/// @name Writers
/// @{
Json ToJson(const RayCounts& rays);
Json ToJson(const RunPictures& pictures);  ///< Without the empty names.
Json ToJson(const BoundResult& bound);
Json ToJson(const Decomposition& decomposition);
Json ToJson(const TemporalResult& temporal);
Json ToJson(const LiveResult& live);
/// @}

/// @name Readers
/// @{
RayCounts ToRayCounts(const Json& json);
RunPictures ToPictures(const Json& json);
BoundResult ToBound(const Json& json);
Decomposition ToDecomposition(const Json& json);
TemporalResult ToTemporal(const Json& json);
LiveResult ToLive(const Json& json);
/// @}

/// null for none.
Json OptionalToJson(std::optional<double> value);
/// None for null.
std::optional<double> ToOptional(const Json& json);

}  // namespace rtb
