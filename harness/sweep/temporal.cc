/// @file
/// A temporal unit: one encoder on the frames of a moving scene.
#include "harness/measure/temporal.h"

#include "harness/bench_rounds.h"
#include "harness/sweep/outcome.h"

namespace rtb {

Result<BenchResult> DrawOnce(const SweepUnit& unit, Workbench& bench) {
  RTB_ASSIGN_OR_RETURN(const EncoderSpec spec,
                       ParseEncoderSpec(unit.configuration.encoders.front()));
  std::vector<Configuration> one(1);
  RTB_ASSIGN_OR_RETURN(one.front(), MakeConfiguration(spec));
  RTB_ASSIGN_OR_RETURN(const PreparedScene* const scene, bench.Scene(unit));
  BenchRequest request = RequestOf(unit, bench.threads());
  request.score = false;
  ReferencePicture self;
  self.name = "self";
  return Bench(
      request, {*scene, self, Image()}, [](double, const std::string&) {}, one);
}

Status RunTemporal(const SweepUnit& unit, Workbench& bench,
                   const UnitProgress& progress, UnitOutcome& outcome) {
  RTB_ASSIGN_OR_RETURN(BenchResult result, DrawOnce(unit, bench));
  RTB_ASSIGN_OR_RETURN(const PreparedScene* const scene, bench.Scene(unit));
  const BenchRequest request = RequestOf(unit, bench.threads());
  TemporalRequest moving{*scene, unit.configuration.encoders.front(),
                         request.grid, request.depth, request.decode};
  moving.frames = unit.frames;
  moving.fps = unit.fps;
  moving.cache = request.cache;
  const auto show = [&](double share, const std::string&) { progress(share); };
  RTB_ASSIGN_OR_RETURN(result.record.runs.front().temporal,
                       MeasureTemporal(moving, show));
  outcome.record.manifest = std::move(result.record.manifest);
  outcome.record.runs = std::move(result.record.runs);
  return {};
}

}  // namespace rtb
