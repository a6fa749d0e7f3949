/// @file
/// The main job: encoders on a scene, rendered, encoded, timed and scored.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "encoders/cell_grid.h"
#include "encoders/color_depth.h"
#include "encoders/decode.h"
#include "harness/prepared_scene.h"
#include "harness/reference_choice.h"
#include "harness/results/run_record.h"

namespace rtb {

/// What a user asks for.
struct BenchRequest {
  SceneRequest scene;
  std::string encoders = "all";  ///< `SPEC[,SPEC...]` or `all`.
  GridSize grid{120, 40};
  ColorDepth depth = ColorDepth::kTruecolor;
  DecodeOptions decode;
  std::string reference;  ///< As ChooseReference takes it.
  /// Timed runs of each encoder; 0: one run that is not timed.
  int repeat = 10;
  bool score = true;  ///< Whether metrics are computed, and a reference read.
  /// Whether errors are decomposed and compared with their bounds, which takes
  /// a converged image of our own.
  bool decompose = false;
  std::filesystem::path cache = {};  ///< Of measure/cache.h; empty: none.
  bool flip_maps = false;   ///< Whether pictures come with their FLIP maps.
  bool keep_going = false;  ///< Whether the others go on when one fails.
};

/// What an encoder drew.
struct BenchPicture {
  std::string encoder;  ///< Its SPEC.
  CellGrid grid;
  Image decoded;  ///< sRGB-encoded, before it is brought to a common size.
  Image flip;     ///< Its FLIP map as a picture, where it was asked for.
};

/// The record (its conditions are left to the caller) and the pictures, one
/// for each run.
struct BenchResult {
  RunRecord record;
  std::vector<BenchPicture> pictures;
  /// sRGB-encoded, rounded to 8 bits, at its own size; empty without score.
  Image reference;
  std::vector<std::string> notes;  ///< What a user should know, if anything.
};

/// Runs the job. Record::runs carry their rays and bytes. Times follow the
/// protocol: three warm-up rounds, then `repeat` rounds in which the encoders
/// take turns in a random order that depends on nothing but the round.
/// @param progress called with the finished share of the timed runs.
Result<BenchResult> Bench(
    const BenchRequest& request,
    const std::function<void(double share, const std::string& what)>& progress);

/// What a job is done with, for those who do many with the same.
struct BenchStage {
  const PreparedScene& scene;  ///< With the request's options.
  /// Where nothing is scored, a picture of that name alone: `none`.
  const ReferencePicture& reference;
  /// Our own as displayed, not rounded; empty where nothing is decomposed.
  const Image& converged;
};

/// Our own picture of a scene, as displayed, for BenchStage.
/// @return ConvergedImage's errors.
Result<Image> ConvergedPicture(const PreparedScene& scene, PixelSize raster,
                               const std::filesystem::path& cache);

struct Configuration;

/// The same on a stage, with encoders that were made already. Those that fail
/// while the request keeps going are marked, and have no run in the result.
Result<BenchResult> Bench(
    const BenchRequest& request, const BenchStage& stage,
    const std::function<void(double share, const std::string& what)>& progress,
    std::vector<Configuration>& configurations);

}  // namespace rtb
