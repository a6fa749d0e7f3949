#include "harness/bench.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include "core/math/random.h"
#include "encoders/registry.h"
#include "harness/cell_shape.h"
#include "harness/inputs.h"
#include "harness/rasters.h"
#include "harness/reference_choice.h"
#include "harness/run_encoder.h"

namespace rtb {
namespace {

constexpr int kWarmUps = 3;

/// An encoder with what was measured of it.
struct Configuration {
  std::string spec;
  std::string version;  ///< Of the library behind the encoder, if any.
  std::unique_ptr<Encoder> encoder;
  Encoding encoding;
  StageTimes plan{"plan", {}, {}};
  StageTimes render{"render", {}, {}};
  StageTimes encode{"encode", {}, {}};
};

std::string VersionOf(const EncoderSpec& spec) {
  const auto name = [](const EncoderEntry& entry) { return entry.info.name; };
  const auto entry = std::ranges::find(EncoderEntries(), spec.name, name);
  RTB_CHECK(entry != EncoderEntries().end());
  return entry->info.version;
}

Result<std::vector<Configuration>> MakeConfigurations(
    const std::string& encoders) {
  RTB_ASSIGN_OR_RETURN(const std::vector<EncoderSpec> specs,
                       ParseEncoderSpecs(encoders));
  std::vector<Configuration> configurations;
  for (const EncoderSpec& spec : specs) {
    Configuration configuration;
    configuration.spec = spec.text;
    configuration.version = VersionOf(spec);
    RTB_ASSIGN_OR_RETURN(configuration.encoder, MakeEncoder(spec));
    configurations.push_back(std::move(configuration));
  }
  return configurations;
}

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

/// One run of one configuration; every run must draw the same grid.
Status RunOnce(const BenchRequest& request, const PreparedScene& scene,
               bool warm_up, Configuration& configuration) {
  SceneSource source = scene.Source();
  EncodeContext context;
  context.seed = scene.options.seed;
  context.threads = scene.options.threads;
  context.depth = request.depth;
  RTB_ASSIGN_OR_RETURN(TimedEncoding run,
                       RunEncoder(*configuration.encoder, source, request.grid,
                                  CellAspect(request.decode), context));
  if (!warm_up) {
    AddTime(run.plan, configuration.plan);
    AddTime(run.render, configuration.render);
    AddTime(run.encode, configuration.encode);
  }
  Encoding& first = configuration.encoding;
  if (first.grid.cells.empty()) {
    first = std::move(run.encoding);
  } else if (first.grid != run.encoding.grid) {
    // Another program's doing: our encoders are functions of their arguments.
    return Fail(
        Failure(configuration.spec, "drew other cells when it was run again"));
  }
  return {};
}

Status RunRounds(
    const BenchRequest& request, const PreparedScene& scene,
    const std::function<void(double, const std::string&)>& progress,
    std::vector<Configuration>& configurations) {
  const int rounds = kWarmUps + request.repeat;
  for (int round = 0; round < rounds; ++round) {
    for (const std::size_t i : RoundOrder(configurations.size(), round)) {
      RTB_RETURN_IF_ERROR(
          RunOnce(request, scene, round < kWarmUps, configurations[i]));
    }
    progress((round + 1.0) / rounds, "timing");
  }
  return {};
}

/// Decodes and scores what a configuration drew.
Status Evaluate(const BenchRequest& request, const PreparedScene& scene,
                Configuration& configuration, BenchResult& result) {
  BenchPicture picture;
  picture.encoder = configuration.spec;
  picture.grid = std::move(configuration.encoding.grid);
  DecodeOptions decode = request.decode;
  decode.threads = scene.options.threads;
  RTB_ASSIGN_OR_RETURN(picture.decoded, Decode(picture.grid, decode));
  RTB_ASSIGN_OR_RETURN(
      const RasterPair pair,
      MatchRasters(result.reference, picture.decoded, "--reference"));
  RunResult run;
  run.scene = scene.scene->name;
  run.encoder = configuration.spec;
  run.encoder_version = configuration.version;
  run.grid = request.grid;
  // Each sample that the encoder asks for takes `spp` rays.
  run.rays_per_cell = configuration.encoding.rays_per_cell * scene.options.spp;
  run.raster = {pair.test.width(), pair.test.height()};
  run.reference_raster = pair.reference_size;
  run.times = {configuration.plan, configuration.render, configuration.encode};
  RTB_ASSIGN_OR_RETURN(run.metrics,
                       Score(pair.reference, pair.test, scene.options.threads));
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

Result<BenchResult> Bench(
    const BenchRequest& request,
    const std::function<void(double, const std::string&)>& progress) {
  RTB_ASSIGN_OR_RETURN(std::vector<Configuration> configurations,
                       MakeConfigurations(request.encoders));
  RTB_ASSIGN_OR_RETURN(const PixelSize raster,
                       RasterSize(request.grid, CellOf(request.decode)));
  RTB_RETURN_IF_ERROR(CheckFont(request.decode));
  RTB_ASSIGN_OR_RETURN(const PreparedScene scene, PrepareScene(request.scene));
  RTB_ASSIGN_OR_RETURN(ReferencePicture reference,
                       ChooseReference(request.reference, scene, raster));
  BenchResult result;
  Manifest& manifest = result.record.manifest;
  manifest.build = GetBuildInfo();
  manifest.settings = SharedSettings(request, scene, reference);
  result.reference = std::move(reference.display);
  result.notes = std::move(reference.notes);
  RTB_RETURN_IF_ERROR(RunRounds(request, scene, progress, configurations));
  for (Configuration& configuration : configurations) {
    RTB_RETURN_IF_ERROR(Evaluate(request, scene, configuration, result));
  }
  RTB_ASSIGN_OR_RETURN(manifest.inputs,
                       Inputs(request, scene, reference, result));
  return result;
}

}  // namespace rtb
