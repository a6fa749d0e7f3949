#include "harness/results/cost_table.h"

#include <algorithm>

#include "core/base/error.h"
#include "harness/results/statistics.h"
#include "harness/results/table.h"

namespace rtb {
namespace {

constexpr double kMillion = 1e6;

std::vector<std::string> Row(const RunResult& run) {
  const RayCounts& rays = *run.rays;
  const auto rate = RaysPerSecond(run);
  return {run.encoder,
          std::to_string(rays.camera),
          std::to_string(rays.reflection),
          std::to_string(rays.refraction),
          std::to_string(rays.scattered),
          std::to_string(rays.shadow),
          rate ? FormatFixed(*rate / kMillion, 2) : "-",
          run.bytes_per_frame ? std::to_string(*run.bytes_per_frame) : "-"};
}

/// What every encoder's first frame waits for.
std::string FirstFrame(const RunResult& run) {
  const StageTimes* load = FindStage(run, "load");
  const StageTimes* build = FindStage(run, "build");
  if (load == nullptr || build == nullptr) return "";
  return "loading the scene takes " + FormatFixed(Median(load->samples), 2) +
         " ms, building its accelerator " +
         FormatFixed(Median(build->samples), 2) + " ms\n";
}

}  // namespace

std::optional<double> RaysPerSecond(const RunResult& run) {
  const StageTimes* render = FindStage(run, "render");
  if (!run.rays || render == nullptr) return std::nullopt;
  const double ms = Median(render->samples);
  if (!(ms > 0)) return std::nullopt;
  return static_cast<double>(run.rays->total()) * 1000 / ms;
}

std::string FormatCostTable(std::span<const RunResult* const> runs) {
  Table table{{{"encoder", false},
               {"camera rays"},
               {"reflected"},
               {"refracted"},
               {"scattered"},
               {"shadow"},
               {"Mrays/s"},
               {"bytes/frame"}},
              {}};
  for (const RunResult* run : runs) {
    if (run->rays) table.rows.push_back(Row(*run));
  }
  if (table.rows.empty()) return "";
  return FormatTable(table) + FirstFrame(*runs.front());
}

}  // namespace rtb
