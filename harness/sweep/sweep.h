/// @file
/// A sweep: all units of a suite, or a slice of them, run and recorded.
#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "harness/sweep/folder.h"
#include "harness/sweep/shard.h"
#include "harness/sweep/suite.h"
#include "harness/sweep/unit.h"

namespace rtb {

/// What a user asks for.
struct SweepRequest {
  std::filesystem::path suite;
  std::filesystem::path out;
  bool resume = false;
  /// Units at a time; with more than one, those whose times count are left.
  int jobs = 1;
  int threads = 0;  ///< In all; 0 = all cores.
  Shard shard;
  std::set<UnitKind> kinds;          ///< Empty = all.
  std::vector<std::string> command;  ///< For the records.
};

/// The units of a request.
struct SweepPlan {
  std::string text;  ///< The suite's file.
  Suite suite;
  std::vector<SweepUnit> all;    ///< Of the whole suite, hashes set.
  std::vector<SweepUnit> units;  ///< Of the shard and the kinds asked for.
};

/// How a sweep tells what it does. Called from one thread at a time.
struct SweepObserver {
  std::function<void(double share, const std::string& what)> progress;
  std::function<void(const std::string& text)> note;
  /// Asked before each unit; true ends the sweep.
  std::function<bool()> interrupted;
};

/// What became of the units.
struct SweepSummary {
  int present = 0;  ///< Were there already.
  int done = 0;
  int failed = 0;
  int skipped = 0;    ///< For want of a program, a library or a device.
  int postponed = 0;  ///< Timed ones, because of `jobs`.
  int left = 0;       ///< Not tried, because of an interruption.
};

/// Reads the suite and lists its units.
Result<SweepPlan> PlanSweep(const SweepRequest& request);

/// Runs what is not there yet: units that count no times, the scenes one after
/// the other or in parallel, then serially those that do. Each unit's failure
/// is its record's.
/// @return an Error when the folder cannot be used or written.
Result<SweepSummary> RunSweep(const SweepRequest& request,
                              const SweepPlan& plan,
                              const SweepObserver& observer);

}  // namespace rtb
