/// @file
/// A live unit: one encoder in the live mode, drawing into a pseudo terminal.
#include "harness/live/headless.h"
#include "harness/sweep/outcome.h"

namespace rtb {
namespace {

LiveResult ResultOf(const LiveFigures& figures) {
  return {figures.fps,
          {figures.frame_ms.p50, figures.frame_ms.p95, figures.frame_ms.p99},
          figures.bytes_per_frame,
          figures.cells_per_frame,
          figures.present};
}

/// As fast as it goes: a governor would change what is drawn.
LiveRequest LiveRequestOf(const SweepUnit& unit, const Workbench& bench) {
  const BenchRequest job = RequestOf(unit, bench.threads());
  LiveRequest request;
  request.scene = job.scene;
  request.encoder = unit.configuration.encoders.front();
  request.depth = unit.depth;
  request.target_fps = 0;
  request.present = PresentMode::kDirect;
  request.term = "xterm-256color";
  request.color_term = "truecolor";
  request.grid = job.grid;
  request.frames = unit.frames;
  return request;
}

}  // namespace

Status RunLive(const SweepUnit& unit, Workbench& bench, UnitOutcome& outcome) {
  RTB_ASSIGN_OR_RETURN(RunRecord record, RecordOneFrame(unit, bench, "none"));
  RTB_ASSIGN_OR_RETURN(const LiveFigures figures,
                       RunHeadless(LiveRequestOf(unit, bench)));
  record.runs.front().live = ResultOf(figures);
  outcome.record.manifest = std::move(record.manifest);
  outcome.record.runs = std::move(record.runs);
  return {};
}

}  // namespace rtb
