#include "harness/sweep/sweep.h"

#include <algorithm>

#include "core/base/file.h"
#include "core/base/manifest.h"
#include "core/scene/yaml_tree.h"
#include "harness/sweep/crew.h"
#include "harness/sweep/expand.h"
#include "harness/sweep/identity.h"

namespace rtb {
namespace {

/// Splits off the units that are still to be run.
std::vector<SweepUnit> ToRun(const SweepRequest& request, const SweepPlan& plan,
                             const SweepFolder& folder, SweepSummary& summary) {
  std::vector<SweepUnit> units;
  for (const SweepUnit& unit : plan.units) {
    if (folder.StateOf(unit) == UnitState::kDone) {
      ++summary.present;
    } else if (request.jobs > 1 && IsTimed(unit.kind)) {
      ++summary.postponed;
    } else {
      units.push_back(unit);
    }
  }
  return units;
}

void NoteMoved(int moved, const SweepObserver& observer) {
  if (moved == 0) return;
  observer.note(std::to_string(moved) +
                " records are not of this suite: they now lie in superseded/");
}

}  // namespace

Result<SweepPlan> PlanSweep(const SweepRequest& request) {
  SweepPlan plan;
  RTB_ASSIGN_OR_RETURN(plan.text, ReadFile(request.suite, kMaxYamlBytes));
  RTB_ASSIGN_OR_RETURN(plan.suite,
                       ParseSuite(plan.text, request.suite, FindDataFolders()));
  plan.all = Expand(plan.suite);
  Identify(plan.all);
  plan.units = SliceOf(plan.all, request.shard);
  if (!request.kinds.empty()) {
    std::erase_if(plan.units, [&request](const SweepUnit& unit) {
      return !request.kinds.contains(unit.kind);
    });
  }
  return plan;
}

Result<SweepSummary> RunSweep(const SweepRequest& request,
                              const SweepPlan& plan,
                              const SweepObserver& observer) {
  RTB_ASSIGN_OR_RETURN(
      SweepFolder folder,
      SweepFolder::Open(request.out, plan.text, request.resume));
  RTB_ASSIGN_OR_RETURN(const int moved, folder.KeepOnly(plan.all));
  NoteMoved(moved, observer);
  SweepSummary summary;
  const std::vector<SweepUnit> units = ToRun(request, plan, folder, summary);
  for (const SweepUnit& unit : plan.units) {
    if (folder.StateOf(unit) != UnitState::kDone) continue;
    RTB_RETURN_IF_ERROR(folder.Supersede(unit));
  }
  Crew crew(request, plan.suite.name, folder, observer, summary);
  RTB_RETURN_IF_ERROR(crew.Run(units));
  return summary;
}

}  // namespace rtb
