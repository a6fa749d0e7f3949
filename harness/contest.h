/// @file
/// Contestants: encoders that draw the same scene on the same grid, run once
/// or timed in rounds in which they take turns.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "encoders/decode.h"
#include "encoders/registry.h"
#include "harness/prepared_scene.h"
#include "harness/results/run_record.h"

namespace rtb {

/// An encoder with what was measured of it.
struct Contestant {
  std::string spec;
  std::string version;  ///< As EncoderVersion says.
  std::unique_ptr<Encoder> encoder;
  Encoding encoding;  ///< Of its first run.
  StageTimes plan{"plan", {}, {}};
  StageTimes render{"render", {}, {}};
  StageTimes encode{"encode", {}, {}};
  std::optional<Error> failure;  ///< Once it has failed, it is not run again.
};

/// What all contestants draw.
struct ContestTask {
  GridSize grid{120, 40};
  ColorDepth depth = ColorDepth::kTruecolor;
  double cell_aspect = 0.5;  ///< Width / height of a cell.
};

/// How they take turns.
struct Rounds {
  int timed = 10;           ///< Rounds after three warm-up rounds.
  bool keep_going = false;  ///< Whether the others go on when one fails.
  /// Called after each round with the finished share.
  std::function<void(double share, const std::string& what)> progress;
};

/// Makes the encoder of a SPEC.
Result<Contestant> MakeContestant(const EncoderSpec& spec);

/// One run; its times are kept, and so are the cells of the first run.
/// @param warm_up no times are kept.
/// @return an Error also when it draws other cells than in its first run.
Status RunContestant(const ContestTask& task, const PreparedScene& scene,
                     bool warm_up, Contestant& contestant);

/// Runs all in rounds, in each in a random order that depends on nothing but
/// the round (METRICS, section 5). Whoever fails is marked and left out of
/// what follows.
/// @return the first failure, unless the others keep going.
Status RunRounds(const ContestTask& task, const PreparedScene& scene,
                 const Rounds& rounds, std::vector<Contestant>& contestants);

}  // namespace rtb
