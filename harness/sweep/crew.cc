#include "harness/sweep/crew.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <utility>

#include "core/base/manifest.h"

namespace rtb {
namespace {

/// Roughly how long a unit takes, in any unit of time: for progress alone.
double Effort(const SweepUnit& unit) {
  constexpr double kUsualCells = 120 * 40;
  const UnitConfiguration& c = unit.configuration;
  const double cells = c.grid.columns * c.grid.rows / kUsualCells;
  const double runs = unit.kind == UnitKind::kTiming ? 0.05 * unit.repeat : 1;
  const double frames = std::max(unit.frames, 1);
  return 0.05 + cells * runs * frames * static_cast<double>(c.encoders.size());
}

/// Consecutive units of one scene.
std::vector<std::span<const SweepUnit>> ByScene(
    std::span<const SweepUnit> units) {
  std::vector<std::span<const SweepUnit>> groups;
  while (!units.empty()) {
    const auto other = [&](const SweepUnit& unit) {
      return unit.scene_file != units.front().scene_file;
    };
    const auto end = std::ranges::find_if(units, other);
    const auto count = static_cast<std::size_t>(end - units.begin());
    groups.push_back(units.first(count));
    units = units.subspan(count);
  }
  return groups;
}

}  // namespace

Status Crew::Run(std::span<const SweepUnit> units) {
  for (const SweepUnit& unit : units) all_work_ += Effort(unit);
  summary_.left = static_cast<int>(units.size());
  const auto timed = std::ranges::find_if(
      units, [](const SweepUnit& unit) { return IsTimed(unit.kind); });
  const auto untimed = static_cast<std::size_t>(timed - units.begin());
  RunGroups(ByScene(units.first(untimed)), request_.jobs);
  RunGroups(ByScene(units.subspan(untimed)), 1);
  return status_;
}

void Crew::RunGroups(const std::vector<Group>& groups, int workers) {
  const int cores =
      request_.threads > 0 ? request_.threads : GetHostInfo().cores;
  const int threads =
      workers == 1 ? request_.threads : std::max(1, cores / workers);
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < groups.size(); i = next++) {
      Workbench bench(threads);
      for (const SweepUnit& unit : groups[i]) {
        if (!GoOn()) return;
        RunOne(unit, bench);
      }
    }
  };
  std::vector<std::jthread> others;
  for (int i = 1; i < workers; ++i) others.emplace_back(work);
  work();
}

bool Crew::GoOn() {
  const std::lock_guard lock(mutex_);
  return status_ && !observer_.interrupted();
}

void Crew::RunOne(const SweepUnit& unit, Workbench& bench) {
  Show(unit, 0);
  RunConditions conditions{UtcNow(), request_.command, bench.threads(),
                           GetHostInfo()};
  UnitOutcome outcome =
      RunUnit(unit, suite_, bench, [&](double share) { Show(unit, share); });
  outcome.record.conditions = std::move(conditions);
  const std::lock_guard lock(mutex_);
  Status written = folder_.Write(unit, outcome.record, outcome.files);
  if (!written) {
    status_ = std::move(written);
    return;
  }
  Count(unit, outcome);
}

void Crew::Count(const SweepUnit& unit, const UnitOutcome& outcome) {
  finished_work_ += Effort(unit);
  --summary_.left;
  for (const std::string& note : outcome.notes) Note(note);
  const auto& failure = outcome.record.failure;
  if (!failure) {
    ++summary_.done;
    return;
  }
  const std::string why =
      failure->place + ": " + failure->what +
      (failure->hint.empty() ? "" : " (" + failure->hint + ")");
  if (failure->kind == "skipped") {
    // Each missing program once, not once for each unit.
    ++(outcome.record.runs.empty() ? summary_.skipped : summary_.done);
    Note("skipped: " + why);
  } else {
    ++summary_.failed;
    Note("failed: " + Describe(unit) + ": " + why);
  }
}

void Crew::Note(const std::string& text) {
  if (noted_.insert(text).second) observer_.note(text);
}

void Crew::Show(const SweepUnit& unit, double share_of_unit) {
  const std::lock_guard lock(mutex_);
  const double finished = finished_work_ + share_of_unit * Effort(unit);
  observer_.progress(finished / std::max(all_work_, 1e-9), Describe(unit));
}

}  // namespace rtb
