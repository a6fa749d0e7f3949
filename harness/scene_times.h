/// @file
/// What making a scene ready takes, which every encoder's first frame waits
/// for.
#pragma once

#include "harness/prepared_scene.h"
#include "harness/results/run_record.h"

namespace rtb {

/// Repeated timings of one scene.
struct SceneTimes {
  StageTimes load{"load", {}, {}};    ///< Its file and all that it names.
  StageTimes build{"build", {}, {}};  ///< Backend and first ray.
};

/// Loads the scene and makes its backend anew: `warm_ups` times, then `repeat`
/// times that count.
Result<SceneTimes> TimeScene(const PreparedScene& scene, int warm_ups,
                             int repeat);

}  // namespace rtb
