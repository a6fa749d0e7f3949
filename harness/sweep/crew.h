/// @file
/// Crew: the workers of a sweep.
#pragma once

#include <mutex>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "harness/sweep/folder.h"
#include "harness/sweep/outcome.h"
#include "harness/sweep/sweep.h"

namespace rtb {

/// Runs units and keeps count. All references must outlive it.
class Crew {
 public:
  Crew(const SweepRequest& request, std::string suite, SweepFolder& folder,
       const SweepObserver& observer, SweepSummary& summary)
      : request_(request),
        suite_(std::move(suite)),
        folder_(folder),
        observer_(observer),
        summary_(summary) {}

  /// Runs the units: those that count no times by `jobs` workers, each of
  /// which takes a scene at a time; then the others alone.
  /// @return the error of the folder that ended the work.
  Status Run(std::span<const SweepUnit> units);

 private:
  /// The units of one scene.
  using Group = std::span<const SweepUnit>;

  void RunGroups(const std::vector<Group>& groups, int workers);
  void RunOne(const SweepUnit& unit, Workbench& bench);
  void Count(const SweepUnit& unit, const UnitOutcome& outcome);
  void Note(const std::string& text);
  void Show(const SweepUnit& unit, double share_of_unit);
  /// Whether the next unit may begin.
  bool GoOn();

  const SweepRequest& request_;
  const std::string suite_;
  SweepFolder& folder_;
  const SweepObserver& observer_;
  SweepSummary& summary_;

  std::mutex mutex_;  ///< Guards all that follows, folder, observer, summary.
  Status status_;
  std::set<std::string> noted_;
  double all_work_ = 0;  ///< In units of Effort.
  double finished_work_ = 0;
};

}  // namespace rtb
