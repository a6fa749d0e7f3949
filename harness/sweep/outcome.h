/// @file
/// UnitOutcome: what becomes of a unit, whether it can be done or not.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "harness/results/run_record.h"
#include "harness/sweep/folder.h"
#include "harness/sweep/unit.h"
#include "harness/sweep/workbench.h"

namespace rtb {

/// A record with the files that belong to it.
struct UnitOutcome {
  RunRecord record;  ///< Its conditions are left to the caller.
  std::vector<UnitFile> files;
  std::vector<std::string> notes;  ///< What a user should know, if anything.
};

/// Told of the finished share of one unit.
using UnitProgress = std::function<void(double share)>;

/// Does a unit's work. A failure becomes part of the record.
UnitOutcome RunUnit(const SweepUnit& unit, const std::string& suite,
                    Workbench& bench, const UnitProgress& progress);

/// @name The kinds, each in a file of its own. They fill manifest, runs and
/// files; a run that fails among others is noted in the record.
/// @{
Status RunQuality(const SweepUnit& unit, Workbench& bench,
                  UnitOutcome& outcome);
Status RunTemporal(const SweepUnit& unit, Workbench& bench,
                   const UnitProgress& progress, UnitOutcome& outcome);
Status RunTiming(const SweepUnit& unit, Workbench& bench,
                 const UnitProgress& progress, UnitOutcome& outcome);
Status RunLive(const SweepUnit& unit, Workbench& bench, UnitOutcome& outcome);
/// @}

/// One picture by the unit's encoder, not scored: what its frames take.
Result<BenchResult> DrawOnce(const SweepUnit& unit, Workbench& bench);

/// An Error as records keep it. @param encoder the SPEC that failed, if any.
RunFailure ToFailure(const Error& error, const std::string& encoder);

}  // namespace rtb
