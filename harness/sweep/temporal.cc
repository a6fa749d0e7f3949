/// @file
/// A temporal unit: one encoder on the frames of a moving scene.
#include "harness/measure/temporal.h"

#include "harness/sweep/outcome.h"

namespace rtb {

Status RunTemporal(const SweepUnit& unit, Workbench& bench,
                   const UnitProgress& progress, UnitOutcome& outcome) {
  RTB_ASSIGN_OR_RETURN(RunRecord record, RecordOneFrame(unit, bench, "self"));
  RTB_ASSIGN_OR_RETURN(const PreparedScene* const scene, bench.Scene(unit));
  const BenchRequest request = RequestOf(unit, bench.threads());
  TemporalRequest moving{*scene, unit.configuration.encoders.front(),
                         request.grid, request.depth, request.decode};
  moving.frames = unit.frames;
  moving.fps = unit.fps;
  moving.cache = request.cache;
  const auto show = [&](double share, const std::string&) { progress(share); };
  RTB_ASSIGN_OR_RETURN(record.runs.front().temporal,
                       MeasureTemporal(moving, show));
  outcome.record.manifest = std::move(record.manifest);
  outcome.record.runs = std::move(record.runs);
  return {};
}

}  // namespace rtb
