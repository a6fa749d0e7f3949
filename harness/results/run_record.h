/// @file
/// RunRecord: the result of the main job, as plain data. run_record_json.h
/// writes and reads it; results/record.schema.json describes that form.
///
/// All that may differ between two runs of the same work by the same program,
/// on one machine or two, sits in RunResult::times and in
/// RunRecord::conditions; the rest of a record is identical byte for byte.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/manifest.h"
#include "core/render/ray_counts.h"
#include "core/render/sample_plan.h"
#include "harness/metrics/metric.h"
#include "harness/pixel_size.h"
#include "harness/results/bound.h"
#include "harness/results/decomposition.h"
#include "harness/results/failure.h"
#include "harness/results/live_result.h"
#include "harness/results/pictures.h"
#include "harness/results/temporal_result.h"
#include "harness/results/unit.h"

namespace rtb {

/// Version of the records' form; to be raised when a key changes its meaning.
inline constexpr int kRecordSchema = 1;

/// Repeated timings of one stage of a run, in milliseconds and in the order
/// they were taken: `load` (the scene's file), `build` (the acceleration
/// structure), `plan`, `render`, `encode` (see TimedEncoding), `decode`,
/// `emit` (the grid as ANSI text).
struct StageTimes {
  std::string stage;
  std::vector<double> samples;      ///< Wall time; at least one.
  std::vector<double> cpu_samples;  ///< CPU time of the same runs, or empty.
  bool operator==(const StageTimes&) const = default;
};

/// One encoder on one scene.
struct RunResult {
  std::string scene;
  std::string encoder;  ///< Its SPEC, as given.
  GridSize grid;
  double rays_per_cell = 0;    ///< Mean over cells.
  PixelSize raster;            ///< On which the images were compared.
  PixelSize reference_raster;  ///< The reference's own size.
  std::vector<StageTimes> times;
  std::vector<MetricValue> metrics;
  std::string encoder_version = {};  ///< Of a library that chose; empty = ours.
  std::optional<RayCounts> rays = {};  ///< Of one frame, by kind.
  /// Bytes of the grid as ANSI text.
  std::optional<std::uint64_t> bytes_per_frame = {};
  RunPictures pictures = {};
  /// None where it was not asked for, or the glyphs are not known.
  std::optional<BoundResult> bound = {};
  std::optional<Decomposition> decomposition = {};
  std::optional<TemporalResult> temporal = {};  ///< Of moving scenes.
  std::optional<LiveResult> live = {};          ///< Of live sessions.
};

/// A file that the work depends on.
struct InputFile {
  std::string role;  ///< `scene`, `mesh`, `image`, `reference`, `font`.
  std::string name;  ///< Name without folders.
  std::string sha256;
  bool operator==(const InputFile&) const = default;
};

/// The settings that all runs of a record share; parameters in an encoder's
/// SPEC beat them.
struct RunSettings {
  std::string backend;  ///< The one that really ran.
  std::string device;   ///< Name of the GPU; empty on the CPU.
  std::string integrator;
  int spp = 1;
  int max_depth = 0;  ///< Bounces after the eye ray.
  std::uint64_t seed = 0;
  double time = 0;      ///< Seconds along the scene's movement.
  double exposure = 0;  ///< Stops.
  PixelSize cell{8, 16};
  std::string reference;  ///< `povray`, `cycles`, `self` or a file's name.
  std::string color = "truecolor";
  std::string decode = "geometric";
  std::string blend = "srgb";  ///< Space in which encoders average by default.
  double ppd = 40;             ///< Of the primary measure, FLIP.
  bool operator==(const RunSettings&) const = default;
};

/// What was done, by what, with what.
struct Manifest {
  BuildInfo build;
  RunSettings settings;
  std::vector<InputFile> inputs;
};

/// The circumstances, which no figure but the times may depend on.
struct RunConditions {
  std::string utc;                   ///< Start, `2026-01-31T12:34:56Z`.
  std::vector<std::string> command;  ///< The full command line.
  int threads = 0;                   ///< As asked for; 0 = all cores.
  HostInfo host;
};

/// One file of results.
struct RunRecord {
  Manifest manifest;
  std::vector<RunResult> runs;
  RunConditions conditions;
  std::optional<Unit> unit = {};           ///< Of a sweep.
  std::optional<RunFailure> failure = {};  ///< Of all runs, or of one.
};

/// The times of a stage, or nullptr.
const StageTimes* FindStage(const RunResult& run, const std::string& stage);

/// The value of a metric; none where it is undefined or was not computed.
std::optional<double> FindMetricValue(const RunResult& run,
                                      const std::string& metric);

/// Frames per second if every frame took the median times of planning,
/// rendering and encoding; none without the latter two.
std::optional<double> FramesPerSecond(const RunResult& run);

}  // namespace rtb
