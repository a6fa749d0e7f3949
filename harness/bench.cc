#include "harness/bench.h"

#include <set>
#include <utility>

#include "harness/cell_shape.h"
#include "harness/contest.h"
#include "harness/error_maps.h"
#include "harness/inputs.h"
#include "harness/rasters.h"
#include "harness/reference_choice.h"

namespace rtb {
namespace {

/// One contestant for each SPEC.
Result<std::vector<Contestant>> MakeContestants(const std::string& encoders) {
  RTB_ASSIGN_OR_RETURN(const std::vector<EncoderSpec> specs,
                       ParseEncoderSpecs(encoders));
  std::vector<Contestant> contestants;
  for (const EncoderSpec& spec : specs) {
    RTB_ASSIGN_OR_RETURN(Contestant contestant, MakeContestant(spec));
    contestants.push_back(std::move(contestant));
  }
  return contestants;
}

RunSettings SharedSettings(const BenchRequest& request,
                           const PreparedScene& scene,
                           const std::string& reference) {
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
  settings.reference = reference;
  settings.color = NameOf(request.depth);
  settings.decode =
      request.decode.masks == MaskSource::kFont ? "font" : "geometric";
  return settings;
}

/// The fonts that decoding the pictures opens.
Result<std::vector<InputFile>> Fonts(
    const BenchRequest& request, const std::vector<BenchPicture>& pictures) {
  std::set<char32_t> glyphs;
  for (const BenchPicture& picture : pictures) {
    for (const Cell& cell : picture.grid.cells) glyphs.insert(cell.glyph);
  }
  return FontInputs(glyphs, request.decode);
}

}  // namespace

ContestTask TaskOf(const BenchRequest& request) {
  return {request.grid, request.depth, CellAspect(request.decode)};
}

RunResult DescribeRun(const BenchRequest& request, const PreparedScene& scene,
                      const Contestant& contestant) {
  RunResult run;
  run.scene = scene.scene->name;
  run.encoder = contestant.spec;
  run.encoder_version = contestant.version;
  run.grid = request.grid;
  // Each sample that the encoder asks for takes `spp` rays.
  run.rays_per_cell = contestant.encoding.rays_per_cell * scene.options.spp;
  run.raster = {request.grid.columns * request.decode.cell_width,
                request.grid.rows * request.decode.cell_height};
  run.reference_raster = run.raster;
  if (!contestant.plan.samples.empty()) {
    run.times = {contestant.plan, contestant.render, contestant.encode};
  }
  return run;
}

Status ScoreContestant(const BenchRequest& request, const PreparedScene& scene,
                       Contestant& contestant, BenchResult& result) {
  RunResult run = DescribeRun(request, scene, contestant);
  BenchPicture picture;
  picture.encoder = contestant.spec;
  picture.grid = std::move(contestant.encoding.grid);
  DecodeOptions decode = request.decode;
  decode.threads = scene.options.threads;
  RTB_ASSIGN_OR_RETURN(picture.decoded, Decode(picture.grid, decode));
  RTB_ASSIGN_OR_RETURN(
      const RasterPair pair,
      MatchRasters(result.reference, picture.decoded, "--reference"));
  run.raster = {pair.test.width(), pair.test.height()};
  run.reference_raster = pair.reference_size;
  const MetricInput input(pair.reference, pair.test, scene.options.threads);
  run.metrics = ComputeMetrics(input);
  if (request.flip_maps) picture.flip = FlipPicture(input);
  result.record.runs.push_back(std::move(run));
  result.pictures.push_back(std::move(picture));
  return {};
}

Result<Manifest> MakeManifest(const BenchRequest& request,
                              const PreparedScene& scene,
                              const ReferencePicture& reference,
                              const std::vector<BenchPicture>& pictures) {
  Manifest manifest;
  manifest.build = GetBuildInfo();
  manifest.settings = SharedSettings(request, scene, reference.name);
  RTB_ASSIGN_OR_RETURN(manifest.inputs, SceneInputs(*scene.scene));
  if (!reference.file.empty()) {
    RTB_ASSIGN_OR_RETURN(InputFile file,
                         HashedInput("reference", reference.file));
    manifest.inputs.push_back(std::move(file));
  }
  RTB_ASSIGN_OR_RETURN(const std::vector<InputFile> fonts,
                       Fonts(request, pictures));
  manifest.inputs.insert(manifest.inputs.end(), fonts.begin(), fonts.end());
  return manifest;
}

Result<BenchResult> Bench(
    const BenchRequest& request,
    const std::function<void(double, const std::string&)>& progress) {
  RTB_ASSIGN_OR_RETURN(std::vector<Contestant> contestants,
                       MakeContestants(request.encoders));
  RTB_ASSIGN_OR_RETURN(const PixelSize raster,
                       RasterSize(request.grid, CellOf(request.decode)));
  RTB_RETURN_IF_ERROR(CheckFont(request.decode));
  RTB_ASSIGN_OR_RETURN(const PreparedScene scene, PrepareScene(request.scene));
  RTB_ASSIGN_OR_RETURN(ReferencePicture reference,
                       ChooseReference(request.reference, scene, raster));
  BenchResult result;
  result.reference = std::move(reference.display);
  result.notes = std::move(reference.notes);
  RTB_RETURN_IF_ERROR(RunRounds(
      TaskOf(request), scene, {request.repeat, false, progress}, contestants));
  for (Contestant& contestant : contestants) {
    RTB_RETURN_IF_ERROR(ScoreContestant(request, scene, contestant, result));
  }
  RTB_ASSIGN_OR_RETURN(
      result.record.manifest,
      MakeManifest(request, scene, reference, result.pictures));
  return result;
}

}  // namespace rtb
