#include <benchmark/benchmark.h>

#include <filesystem>
#include <vector>

#include "core/scene/load.h"
#include "tests/bench/bench.h"
#include "tests/scene_files.h"

namespace rtb {
namespace {

const std::filesystem::path kScenes =
    std::filesystem::path(RTB_TEST_SOURCE_DIR) / "scenes";

// The canonical grid's pixels: 120 x 40 cells of 8 x 16.
constexpr int kWidth = 960;
constexpr int kHeight = 640;

void Render(benchmark::State& state, const std::string& name) {
  const auto bench = LoadBenchScene(name);
  if (!bench) return state.SkipWithError(bench.error().what.c_str());
  const SamplePlan plan = PixelPlan(kWidth, kHeight);
  for ([[maybe_unused]] auto _ : state) {
    auto fragments = bench->backend->Render(plan, {});
    if (!fragments) return state.SkipWithError(fragments.error().what.c_str());
    benchmark::DoNotOptimize(*fragments);
  }
  const RayCounts rays = bench->backend->ray_counts();
  state.counters["rays_per_second"] =
      benchmark::Counter(static_cast<double>(rays.total()),
                         benchmark::Counter::kIsIterationInvariantRate);
}

}  // namespace

Result<BenchScene> LoadBenchScene(const std::string& name) {
  RTB_ASSIGN_OR_RETURN(Scene scene, LoadScene(kScenes / (name + ".yaml")));
  BenchScene bench{std::make_unique<Scene>(std::move(scene)), nullptr};
  RTB_ASSIGN_OR_RETURN(bench.backend, MakeBackend("embree", *bench.scene));
  return bench;
}

void RegisterRenderBenchmarks() {
  for (const std::string& name : testing::SceneNames(kScenes)) {
    benchmark::RegisterBenchmark(
        ("render/" + name).c_str(),
        [name](benchmark::State& state) { Render(state, name); })
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace rtb
