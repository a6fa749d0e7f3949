/// @file
/// A live unit: one encoder in the live mode, in a pseudo terminal.
#include "harness/live/headless.h"
#include "harness/sweep/outcome.h"

namespace rtb {
namespace {

/// The camera goes around; every picture has all the rays that its encoder
/// asks for, so that encoders can be compared.
LiveRequest LiveRequestOf(const SweepUnit& unit, const BenchRequest& bench) {
  LiveRequest request;
  request.scene = bench.scene;
  request.encoder = unit.configuration.encoders.front();
  request.depth = unit.depth;
  request.target_fps = 0;
  request.present = PresentMode::kDirect;
  request.grid = bench.grid;
  request.frames = unit.frames;
  return request;
}

LiveResult ResultOf(const LiveFigures& figures) {
  return {figures.fps, figures.frame_ms, figures.bytes_per_frame,
          figures.cells_per_frame, figures.present};
}

}  // namespace

Status RunLive(const SweepUnit& unit, Workbench& bench, UnitOutcome& outcome) {
  RTB_ASSIGN_OR_RETURN(BenchResult result, DrawOnce(unit, bench));
  const BenchRequest request = RequestOf(unit, bench.threads());
  RTB_ASSIGN_OR_RETURN(const LiveFigures figures,
                       RunHeadless(LiveRequestOf(unit, request)));
  result.record.runs.front().live = ResultOf(figures);
  outcome.record.manifest = std::move(result.record.manifest);
  outcome.record.runs = std::move(result.record.runs);
  return {};
}

}  // namespace rtb
