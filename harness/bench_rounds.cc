#include "harness/bench_rounds.h"

#include <numeric>
#include <utility>

#include "core/math/random.h"
#include "encoders/emit/emit.h"
#include "harness/cell_shape.h"
#include "harness/encoder_version.h"
#include "harness/run_encoder.h"

namespace rtb {
namespace {

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

EncodeContext ContextOf(const BenchRequest& request,
                        const PreparedScene& scene) {
  EncodeContext context;
  context.seed = scene.options.seed;
  context.threads = scene.options.threads;
  context.depth = request.depth;
  return context;
}

/// What showing a grid takes.
struct ShowCosts {
  Cost decode;
  Cost emit;
  std::uint64_t bytes = 0;
};

Result<ShowCosts> Show(const CellGrid& grid, const BenchRequest& request,
                       const PreparedScene& scene) {
  ShowCosts costs;
  DecodeOptions options = request.decode;
  options.threads = scene.options.threads;
  const Stopwatch stopwatch;
  const auto raster = Decode(grid, options);
  if (!raster) return Fail(raster.error());
  costs.decode = stopwatch.Read();
  costs.bytes = EmitAnsi(grid, request.depth).size();
  costs.emit = stopwatch.Read() - costs.decode;
  return costs;
}

/// Keeps the first run's grid, which every later one must draw again.
Status Keep(Encoding encoding, Configuration& configuration) {
  Encoding& first = configuration.encoding;
  if (first.grid.cells.empty()) {
    first = std::move(encoding);
  } else if (first.grid != encoding.grid) {
    // Another program's doing: our encoders are functions of their arguments.
    return Fail(
        Failure(configuration.spec, "drew other cells when it was run again"));
  }
  return {};
}

/// One run of one configuration.
Status RunOnce(const BenchRequest& request, const PreparedScene& scene,
               bool timed, Configuration& configuration) {
  SceneSource source = scene.Source();
  RTB_ASSIGN_OR_RETURN(
      TimedEncoding run,
      RunEncoder(*configuration.encoder, source, request.grid,
                 CellAspect(request.decode), ContextOf(request, scene)));
  RTB_ASSIGN_OR_RETURN(const ShowCosts shown,
                       Show(run.encoding.grid, request, scene));
  configuration.rays = source.rays();
  configuration.bytes = shown.bytes;
  if (timed) {
    AddTime(run.plan, configuration.plan);
    AddTime(run.render, configuration.render);
    AddTime(run.encode, configuration.encode);
    AddTime(shown.decode, configuration.decode);
    AddTime(shown.emit, configuration.emit);
  }
  return Keep(std::move(run.encoding), configuration);
}

}  // namespace

Result<Configuration> MakeConfiguration(const EncoderSpec& spec) {
  Configuration configuration;
  configuration.spec = spec.text;
  configuration.version = EncoderVersion(spec);
  RTB_ASSIGN_OR_RETURN(configuration.encoder, MakeEncoder(spec));
  return configuration;
}

Result<std::vector<Configuration>> MakeConfigurations(
    const std::string& encoders) {
  RTB_ASSIGN_OR_RETURN(const std::vector<EncoderSpec> specs,
                       ParseEncoderSpecs(encoders));
  std::vector<Configuration> configurations;
  for (const EncoderSpec& spec : specs) {
    RTB_ASSIGN_OR_RETURN(Configuration configuration, MakeConfiguration(spec));
    configurations.push_back(std::move(configuration));
  }
  return configurations;
}

Status RunRounds(
    const BenchRequest& request, const PreparedScene& scene,
    const std::function<void(double, const std::string&)>& progress,
    std::vector<Configuration>& configurations) {
  const int warm_ups = request.repeat > 0 ? kWarmUps : 1;
  const int rounds = warm_ups + request.repeat;
  for (int round = 0; round < rounds; ++round) {
    for (const std::size_t i : RoundOrder(configurations.size(), round)) {
      Configuration& configuration = configurations[i];
      if (configuration.failure) continue;
      Status status = RunOnce(request, scene, round >= warm_ups, configuration);
      if (status) continue;
      configuration.failure = std::move(status.error());
      if (!request.keep_going) return Fail(*configuration.failure);
    }
    progress((round + 1.0) / rounds,
             request.repeat > 0 ? "timing" : "encoding");
  }
  return {};
}

}  // namespace rtb
