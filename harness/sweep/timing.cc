/// @file
/// A timing unit: a block of encoders that take turns.
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

std::vector<Contestant> MakeBlock(const std::vector<std::string>& encoders,
                                  Dropouts& dropouts) {
  std::vector<Contestant> contestants;
  for (const std::string& encoder : encoders) {
    const auto spec = ParseEncoderSpec(encoder);
    auto contestant =
        spec ? MakeContestant(*spec) : Result<Contestant>(Fail(spec.error()));
    if (contestant) {
      contestants.push_back(std::move(*contestant));
    } else {
      dropouts.Add(encoder, contestant.error());
    }
  }
  return contestants;
}

}  // namespace

Status RunTiming(const SweepUnit& unit, Workbench& bench,
                 const UnitProgress& progress, UnitOutcome& outcome) {
  RTB_ASSIGN_OR_RETURN(const PreparedScene* const scene, bench.Scene(unit));
  Dropouts dropouts;
  std::vector<Contestant> contestants =
      MakeBlock(unit.configuration.encoders, dropouts);
  const BenchRequest request = RequestOf(unit, bench.threads());
  const Rounds rounds{
      request.repeat, /*keep_going=*/true,
      [&](double share, const std::string&) { progress(share); }};
  RTB_RETURN_IF_ERROR(RunRounds(TaskOf(request), *scene, rounds, contestants));
  RunRecord& record = outcome.record;
  for (const Contestant& contestant : contestants) {
    if (contestant.failure) {
      dropouts.Add(contestant.spec, *contestant.failure);
    } else {
      record.runs.push_back(DescribeRun(request, *scene, contestant));
    }
  }
  ReferencePicture none;
  none.name = "none";
  RTB_ASSIGN_OR_RETURN(record.manifest,
                       MakeManifest(request, *scene, none, {}));
  record.failure = dropouts.Summary();
  return {};
}

}  // namespace rtb
