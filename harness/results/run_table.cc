#include "harness/results/run_table.h"

#include <algorithm>
#include <sstream>
#include <vector>

#include "core/base/error.h"
#include "harness/metrics/flip_map.h"
#include "harness/results/cost_table.h"
#include "harness/results/decomposition_table.h"
#include "harness/results/statistics.h"
#include "harness/results/table.h"

namespace rtb {
namespace {

constexpr const char* kUndefined = "-";

bool ShareTable(const RunResult& a, const RunResult& b) {
  return a.scene == b.scene && a.grid == b.grid && a.raster == b.raster;
}

std::string PpdText() { return FormatFixed(kFlipPpd, 0); }

std::string Caption(const RunResult& run) {
  std::ostringstream out;
  out << Printable(run.scene) << ", " << run.grid.columns << "x"
      << run.grid.rows << " cells; compared at " << run.raster.width << "x"
      << run.raster.height << " pixels, FLIP at " << PpdText()
      << " pixels per degree\n";
  return out.str();
}

/// Milliseconds with three significant digits or whole.
std::string FormatMs(double ms) {
  return FormatFixed(ms, ms < 10 ? 2 : ms < 100 ? 1 : 0);
}

std::string FormatTimes(const StageTimes* times) {
  if (times == nullptr) return kUndefined;
  const Interval interval = BootstrapMedian(times->samples);
  return FormatMs(Median(times->samples)) + " [" + FormatMs(interval.lo) + "-" +
         FormatMs(interval.hi) + "]";
}

std::string FormatOptional(std::optional<double> value, int digits) {
  return value ? FormatFixed(*value, digits) : kUndefined;
}

/// Whole where it is whole, as it is for all but adaptive encoders.
std::string FormatRays(double rays) {
  return FormatFixed(rays, rays == static_cast<int>(rays) ? 0 : 2);
}

std::vector<std::string> Row(const RunResult& run) {
  return {run.encoder,
          FormatRays(run.rays_per_cell),
          FormatTimes(FindStage(run, "render")),
          FormatTimes(FindStage(run, "encode")),
          FormatOptional(FramesPerSecond(run), 1),
          FormatOptional(FindMetricValue(run, "mse"), 6),
          FormatOptional(FindMetricValue(run, "psnr"), 2),
          FormatOptional(FindMetricValue(run, "ssim"), 4),
          FormatOptional(FindMetricValue(run, "flip"), 4)};
}

/// Of the stages that the table shows.
std::string Warnings(const RunResult& run) {
  std::string text;
  for (const char* stage : {"render", "encode"}) {
    const StageTimes* times = FindStage(run, stage);
    if (times == nullptr) continue;
    const double cv = CoefficientOfVariation(times->samples);
    if (cv <= kMaxVariation) continue;
    text += "warning: " + Printable(run.encoder) + ": the times of '" +
            std::string(stage) + "' vary by " + FormatFixed(100 * cv, 0) +
            " % (coefficient of variation): do not compare them; run more "
            "often, or on a quieter machine\n";
  }
  return text;
}

/// A further table, apart from the one above.
std::string Below(const std::string& table) {
  return table.empty() ? "" : "\n" + table;
}

}  // namespace

std::string FormatRunTable(std::span<const RunResult> runs) {
  std::string text;
  for (auto first = runs.begin(); first != runs.end(); ++first) {
    const auto same = [&](const RunResult& run) {
      return ShareTable(run, *first);
    };
    if (std::any_of(runs.begin(), first, same)) continue;  // In a table above.
    Table table{{{"encoder", false},
                 {"rays/cell"},
                 {"render ms"},
                 {"encode ms"},
                 {"frames/s"},
                 {"MSE"},
                 {"PSNR dB"},
                 {"SSIM"},
                 {"FLIP@" + PpdText() + "PPD"}},
                {}};
    std::string warnings;
    std::vector<const RunResult*> shown;
    for (auto run = first; run != runs.end(); ++run) {
      if (!same(*run)) continue;
      shown.push_back(&*run);
      table.rows.push_back(Row(*run));
      warnings += Warnings(*run);
    }
    if (!text.empty()) text += "\n";
    text += Caption(*first) + FormatTable(table) + warnings +
            Below(FormatCostTable(shown)) +
            Below(FormatDecompositionTable(shown));
  }
  return text;
}

}  // namespace rtb
