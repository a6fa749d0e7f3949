#include "harness/contest.h"

#include <numeric>
#include <utility>

#include "core/math/random.h"
#include "harness/encoder_version.h"
#include "harness/run_encoder.h"

namespace rtb {
namespace {

constexpr int kWarmUps = 3;

/// The order of one round: a Fisher-Yates shuffle.
std::vector<std::size_t> RoundOrder(std::size_t count, int round) {
  constexpr std::uint64_t kOrderSeed = 5;
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = count; i > 1; --i) {
    const std::uint32_t bits =
        RandomBits(static_cast<std::uint32_t>(i),
                   static_cast<std::uint32_t>(round), 0, kOrderSeed);
    std::swap(order[i - 1], order[bits % i]);
  }
  return order;
}

void AddTime(const Cost& cost, StageTimes& times) {
  times.samples.push_back(cost.wall_ms);
  times.cpu_samples.push_back(cost.cpu_ms);
}

}  // namespace

Result<Contestant> MakeContestant(const EncoderSpec& spec) {
  Contestant contestant;
  contestant.spec = spec.text;
  contestant.version = EncoderVersion(spec);
  RTB_ASSIGN_OR_RETURN(contestant.encoder, MakeEncoder(spec));
  return contestant;
}

Status RunContestant(const ContestTask& task, const PreparedScene& scene,
                     bool warm_up, Contestant& contestant) {
  SceneSource source = scene.Source();
  EncodeContext context;
  context.seed = scene.options.seed;
  context.threads = scene.options.threads;
  context.depth = task.depth;
  RTB_ASSIGN_OR_RETURN(TimedEncoding run,
                       RunEncoder(*contestant.encoder, source, task.grid,
                                  task.cell_aspect, context));
  if (!warm_up) {
    AddTime(run.plan, contestant.plan);
    AddTime(run.render, contestant.render);
    AddTime(run.encode, contestant.encode);
  }
  Encoding& first = contestant.encoding;
  if (first.grid.cells.empty()) {
    first = std::move(run.encoding);
  } else if (first.grid != run.encoding.grid) {
    // Another program's doing: our encoders are functions of their arguments.
    return Fail(
        Failure(contestant.spec, "drew other cells when it was run again"));
  }
  return {};
}

Status RunRounds(const ContestTask& task, const PreparedScene& scene,
                 const Rounds& rounds, std::vector<Contestant>& contestants) {
  const int count = kWarmUps + rounds.timed;
  for (int round = 0; round < count; ++round) {
    for (const std::size_t i : RoundOrder(contestants.size(), round)) {
      Contestant& contestant = contestants[i];
      if (contestant.failure) continue;
      Status status = RunContestant(task, scene, round < kWarmUps, contestant);
      if (status) continue;
      contestant.failure = std::move(status.error());
      if (!rounds.keep_going) return Fail(*contestant.failure);
    }
    rounds.progress((round + 1.0) / count, "timing");
  }
  return {};
}

}  // namespace rtb
