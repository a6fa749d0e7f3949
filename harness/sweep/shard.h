/// @file
/// Shard: the slice of a sweep that one of several machines runs.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "harness/sweep/unit.h"

namespace rtb {

/// Slice `index` (from 0) of `count`.
struct Shard {
  int index = 0;
  int count = 1;
};

/// `I/N` with 0 <= I < N.
Result<Shard> ParseShard(const std::string& place, const std::string& text);

/// The shard's units, in the order of `units`. Blocks - the units that differ
/// in encoder and seed alone - are dealt out in turn and stay whole. The slice
/// depends on the suite alone, never on what is done already; every unit is in
/// exactly one of the N slices.
std::vector<SweepUnit> SliceOf(const std::vector<SweepUnit>& units,
                               Shard shard);

}  // namespace rtb
