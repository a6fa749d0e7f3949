/// @file
/// What units of many frames say of one: manifest, rays and bytes.
#include "harness/bench_rounds.h"
#include "harness/sweep/outcome.h"

namespace rtb {

Result<RunRecord> RecordOneFrame(const SweepUnit& unit, Workbench& bench,
                                 const std::string& reference) {
  RTB_ASSIGN_OR_RETURN(const EncoderSpec spec,
                       ParseEncoderSpec(unit.configuration.encoders.front()));
  std::vector<Configuration> one(1);
  RTB_ASSIGN_OR_RETURN(one.front(), MakeConfiguration(spec));
  RTB_ASSIGN_OR_RETURN(const PreparedScene* const scene, bench.Scene(unit));
  BenchRequest request = RequestOf(unit, bench.threads());
  request.score = false;
  ReferencePicture named;
  named.name = reference;
  const auto unseen = [](double, const std::string&) {};
  RTB_ASSIGN_OR_RETURN(BenchResult result,
                       Bench(request, {*scene, named, Image()}, unseen, one));
  return std::move(result.record);
}

}  // namespace rtb
