/// @file
/// A timing unit: a block of encoders that take turns.
#include "harness/bench_rounds.h"
#include "harness/sweep/outcome.h"

namespace rtb {
namespace {

/// Gathers who cannot be timed, while the others are.
class Dropouts {
 public:
  void Add(const std::string& encoder, const Error& error) {
    const RunFailure failure = ToFailure(error, encoder);
    // A failure weighs more than what is merely missing.
    if (!worst_ || (worst_->kind == "skipped" && failure.kind == "failed")) {
      worst_ = failure;
    }
    ++count_;
  }

  /// The worst of them, in the name of all.
  std::optional<RunFailure> Summary() const {
    if (count_ < 2) return worst_;
    RunFailure summary = *worst_;
    summary.what += "; " + std::to_string(count_ - 1) +
                    " more of the block could not be timed";
    return summary;
  }

 private:
  std::optional<RunFailure> worst_;
  int count_ = 0;
};

std::vector<Configuration> MakeBlock(const std::vector<std::string>& encoders,
                                     Dropouts& dropouts) {
  std::vector<Configuration> block;
  for (const std::string& encoder : encoders) {
    const auto spec = ParseEncoderSpec(encoder);
    auto made = spec ? MakeConfiguration(*spec)
                     : Result<Configuration>(Fail(spec.error()));
    if (made) {
      block.push_back(std::move(*made));
    } else {
      dropouts.Add(encoder, made.error());
    }
  }
  return block;
}

}  // namespace

Status RunTiming(const SweepUnit& unit, Workbench& bench,
                 const UnitProgress& progress, UnitOutcome& outcome) {
  RTB_ASSIGN_OR_RETURN(const PreparedScene* const scene, bench.Scene(unit));
  Dropouts dropouts;
  std::vector<Configuration> block =
      MakeBlock(unit.configuration.encoders, dropouts);
  BenchRequest request = RequestOf(unit, bench.threads());
  request.score = false;
  request.keep_going = true;
  request.repeat = unit.repeat;
  ReferencePicture none;
  none.name = "none";
  RTB_ASSIGN_OR_RETURN(
      BenchResult result,
      Bench(
          request, {*scene, none, Image()},
          [&](double share, const std::string&) { progress(share); }, block));
  for (const Configuration& configuration : block) {
    if (!configuration.failure) continue;
    dropouts.Add(configuration.spec, *configuration.failure);
  }
  RunRecord& record = outcome.record;
  record.manifest = std::move(result.record.manifest);
  record.runs = std::move(result.record.runs);
  record.failure = dropouts.Summary();
  return {};
}

}  // namespace rtb
