/// @file
/// The timed rounds of the main job: encoders taking turns on one scene.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "encoders/registry.h"
#include "harness/bench.h"
#include "harness/prepared_scene.h"
#include "harness/results/run_record.h"

namespace rtb {

/// Runs that count for nothing before those that do.
inline constexpr int kWarmUps = 3;

/// An encoder with what was measured of it.
struct Configuration {
  std::string spec;
  std::string version;  ///< As EncoderVersion says.
  std::unique_ptr<Encoder> encoder;
  Encoding encoding;        ///< Of the first run.
  RayCounts rays;           ///< Of one run.
  std::uint64_t bytes = 0;  ///< Of the grid as ANSI text.
  StageTimes plan{"plan", {}, {}};
  StageTimes render{"render", {}, {}};
  StageTimes encode{"encode", {}, {}};
  StageTimes decode{"decode", {}, {}};
  StageTimes emit{"emit", {}, {}};
  std::optional<Error> failure;  ///< Once it has failed, it is not run again.
};

/// The encoder of a SPEC, nothing measured yet.
Result<Configuration> MakeConfiguration(const EncoderSpec& spec);

/// The encoders of `SPEC[,SPEC...]` or `all`, nothing measured yet.
Result<std::vector<Configuration>> MakeConfigurations(
    const std::string& encoders);

/// Runs them all: kWarmUps rounds, then `request.repeat` rounds that are
/// timed; one round that is not where `repeat` is 0. To draw other cells in
/// another round is a failure. Whoever fails is marked and left out of what
/// follows.
/// @return the first failure, unless the request says to keep going.
Status RunRounds(
    const BenchRequest& request, const PreparedScene& scene,
    const std::function<void(double share, const std::string& what)>& progress,
    std::vector<Configuration>& configurations);

}  // namespace rtb
