/// @file
/// The main job: encoders on a scene, rendered, encoded, timed and scored.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "encoders/cell_grid.h"
#include "encoders/color_depth.h"
#include "encoders/decode.h"
#include "harness/contest.h"
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
  std::string reference;   ///< As ChooseReference takes it.
  int repeat = 10;         ///< Timed runs of each encoder.
  bool flip_maps = false;  ///< Whether pictures come with their FLIP maps.
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
  Image reference;  ///< sRGB-encoded, rounded to 8 bits, at its own size.
  std::vector<std::string> notes;  ///< What a user should know, if anything.
};

/// Runs the job. Times follow the protocol: three warm-up rounds, then
/// `repeat` rounds in which the encoders take turns in a random order that
/// depends on nothing but the round.
/// @param progress called with the finished share of the timed runs.
Result<BenchResult> Bench(
    const BenchRequest& request,
    const std::function<void(double share, const std::string& what)>& progress);

/// @name The parts of the job, for those who time and score apart.
/// @{

/// What the request's contestants draw.
ContestTask TaskOf(const BenchRequest& request);

/// What a record says of a contestant that has run: no metrics, its times if
/// any were taken, the decoded grid's raster.
RunResult DescribeRun(const BenchRequest& request, const PreparedScene& scene,
                      const Contestant& contestant);

/// Decodes and scores what a contestant drew, against the result's reference;
/// adds its run and its picture.
Status ScoreContestant(const BenchRequest& request, const PreparedScene& scene,
                       Contestant& contestant, BenchResult& result);

/// What was done with what. The pictures say which fonts were opened.
Result<Manifest> MakeManifest(const BenchRequest& request,
                              const PreparedScene& scene,
                              const ReferencePicture& reference,
                              const std::vector<BenchPicture>& pictures);
/// @}

}  // namespace rtb
