#include "harness/bench.h"

#include <set>
#include <utility>

#include "core/image/io.h"
#include "harness/bench_rounds.h"
#include "harness/cell_shape.h"
#include "harness/error_maps.h"
#include "harness/inputs.h"
#include "harness/measure/bound.h"
#include "harness/measure/converged_image.h"
#include "harness/measure/decompose.h"
#include "harness/rasters.h"
#include "harness/reference_choice.h"
#include "harness/scene_times.h"

namespace rtb {
namespace {

DecodeOptions DecodeOf(const BenchRequest& request,
                       const PreparedScene& scene) {
  DecodeOptions options = request.decode;
  options.threads = scene.options.threads;
  return options;
}

/// What all runs of the job share.
struct Job {
  const BenchRequest& request;
  const PreparedScene& scene;
  SceneTimes times;
  const Image& converged;  ///< Where errors are to be decomposed.
};

RunResult Describe(const Job& job, const Configuration& configuration) {
  RunResult run;
  run.scene = job.scene.scene->name;
  run.encoder = configuration.spec;
  run.encoder_version = configuration.version;
  run.grid = job.request.grid;
  // Each sample that the encoder asks for takes `spp` rays.
  run.rays_per_cell =
      configuration.encoding.rays_per_cell * job.scene.options.spp;
  run.rays = configuration.rays;
  run.bytes_per_frame = configuration.bytes;
  if (job.request.repeat > 0) {
    run.times = {job.times.load,       job.times.build,
                 configuration.plan,   configuration.render,
                 configuration.encode, configuration.decode,
                 configuration.emit};
  }
  return run;
}

/// Compares what was drawn with the reference.
Status ScoreRun(const Job& job, const BenchResult& result,
                BenchPicture& picture, RunResult& run) {
  const Image& decoded = picture.decoded;
  run.raster = run.reference_raster = {decoded.width(), decoded.height()};
  if (!job.request.score) return {};
  RTB_ASSIGN_OR_RETURN(const RasterPair pair,
                       MatchRasters(result.reference, decoded, "--reference"));
  run.raster = {pair.test.width(), pair.test.height()};
  run.reference_raster = pair.reference_size;
  const MetricInput input(pair.reference, pair.test, job.scene.options.threads);
  run.metrics = ComputeMetrics(input);
  if (job.request.flip_maps) picture.flip = FlipPicture(input);
  return {};
}

/// Where the error comes from, and how much of it the glyphs cannot avoid.
Status Explain(const Job& job, const Configuration& configuration,
               const BenchResult& result, RunResult& run) {
  if (!job.request.decompose) return {};
  const ErrorInput input{job.scene,
                         configuration.spec,
                         *configuration.encoder,
                         configuration.encoding,
                         result.reference,
                         job.converged,
                         DecodeOf(job.request, job.scene),
                         job.request.depth,
                         job.request.cache};
  RTB_ASSIGN_OR_RETURN(run.decomposition, Decompose(input));
  RTB_ASSIGN_OR_RETURN(run.bound, CompareWithBound(input));
  return {};
}

/// Decodes and scores what a configuration drew.
Status Evaluate(const Job& job, Configuration& configuration,
                BenchResult& result) {
  BenchPicture picture;
  picture.encoder = configuration.spec;
  RTB_ASSIGN_OR_RETURN(
      picture.decoded,
      Decode(configuration.encoding.grid, DecodeOf(job.request, job.scene)));
  RunResult run = Describe(job, configuration);
  RTB_RETURN_IF_ERROR(ScoreRun(job, result, picture, run));
  RTB_RETURN_IF_ERROR(Explain(job, configuration, result, run));
  picture.grid = std::move(configuration.encoding.grid);
  result.record.runs.push_back(std::move(run));
  result.pictures.push_back(std::move(picture));
  return {};
}

RunSettings SharedSettings(const BenchRequest& request,
                           const PreparedScene& scene,
                           const ReferencePicture& reference) {
  RunSettings settings;
  settings.backend = scene.backend->name();
  settings.integrator = scene.options.integrator;
  settings.spp = scene.options.spp;
  settings.max_depth = scene.options.max_depth >= 0
                           ? scene.options.max_depth
                           : scene.scene->settings.max_depth;
  settings.seed = scene.options.seed;
  settings.time = scene.options.time;
  settings.exposure = scene.exposure;
  settings.cell = CellOf(request.decode);
  settings.reference = reference.name;
  settings.color = NameOf(request.depth);
  settings.decode =
      request.decode.masks == MaskSource::kFont ? "font" : "geometric";
  return settings;
}

Result<std::vector<InputFile>> Inputs(const BenchRequest& request,
                                      const PreparedScene& scene,
                                      const ReferencePicture& reference,
                                      const BenchResult& result) {
  RTB_ASSIGN_OR_RETURN(std::vector<InputFile> inputs,
                       SceneInputs(*scene.scene));
  if (!reference.file.empty()) {
    RTB_ASSIGN_OR_RETURN(InputFile file,
                         HashedInput("reference", reference.file));
    inputs.push_back(std::move(file));
  }
  std::set<char32_t> glyphs;
  for (const BenchPicture& picture : result.pictures) {
    for (const Cell& cell : picture.grid.cells) glyphs.insert(cell.glyph);
  }
  RTB_ASSIGN_OR_RETURN(const std::vector<InputFile> fonts,
                       FontInputs(glyphs, request.decode));
  inputs.insert(inputs.end(), fonts.begin(), fonts.end());
  return inputs;
}

}  // namespace

Result<Image> ConvergedPicture(const PreparedScene& scene, PixelSize raster,
                               const std::filesystem::path& cache) {
  RTB_ASSIGN_OR_RETURN(
      const Image linear,
      ConvergedImage(scene, scene.options.time, raster, cache));
  return DisplayEncoded(linear, scene.exposure, false);
}

Result<BenchResult> Bench(
    const BenchRequest& request, const BenchStage& stage,
    const std::function<void(double, const std::string&)>& progress,
    std::vector<Configuration>& configurations) {
  RTB_CHECK(request.score || !request.decompose);
  BenchResult result;
  Manifest& manifest = result.record.manifest;
  manifest.build = GetBuildInfo();
  manifest.settings = SharedSettings(request, stage.scene, stage.reference);
  result.reference = stage.reference.display;
  result.notes = stage.reference.notes;
  Job job{request, stage.scene, {}, stage.converged};
  if (request.repeat > 0) {
    RTB_ASSIGN_OR_RETURN(job.times,
                         TimeScene(stage.scene, kWarmUps, request.repeat));
  }
  RTB_RETURN_IF_ERROR(
      RunRounds(request, stage.scene, progress, configurations));
  for (Configuration& configuration : configurations) {
    if (configuration.failure) continue;
    RTB_RETURN_IF_ERROR(Evaluate(job, configuration, result));
  }
  RTB_ASSIGN_OR_RETURN(manifest.inputs,
                       Inputs(request, stage.scene, stage.reference, result));
  return result;
}

Result<BenchResult> Bench(
    const BenchRequest& request,
    const std::function<void(double, const std::string&)>& progress) {
  RTB_ASSIGN_OR_RETURN(std::vector<Configuration> configurations,
                       MakeConfigurations(request.encoders));
  RTB_ASSIGN_OR_RETURN(const PixelSize raster,
                       RasterSize(request.grid, CellOf(request.decode)));
  RTB_RETURN_IF_ERROR(CheckFont(request.decode));
  RTB_ASSIGN_OR_RETURN(const PreparedScene scene, PrepareScene(request.scene));
  ReferencePicture reference;
  reference.name = "none";
  if (request.score) {
    RTB_ASSIGN_OR_RETURN(reference, ChooseReference(request.reference, scene,
                                                    raster, request.cache));
  }
  Image converged;
  if (request.decompose) {
    RTB_ASSIGN_OR_RETURN(converged,
                         ConvergedPicture(scene, raster, request.cache));
  }
  return Bench(request, {scene, reference, converged}, progress,
               configurations);
}

}  // namespace rtb
