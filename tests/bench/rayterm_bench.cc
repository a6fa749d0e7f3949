#include <benchmark/benchmark.h>

#include "tests/bench/bench.h"

namespace rtb {
namespace {

// The work of RAYTERM's CPU prototype, which took about 200 ms on one core of
// 2018: 80 x 52 pixels, 32 samples, depth 5 (scenes/rayterm.yaml).
constexpr int kWidth = 80;
constexpr int kHeight = 52;
constexpr int kRays = 32;

void Rayterm(benchmark::State& state, bool vectors) {
  const auto bench = LoadBenchScene("rayterm");
  if (!bench) return state.SkipWithError(bench.error().what.c_str());
  RenderOptions options;
  options.integrator = "path";
  options.spp = kRays;
  options.threads = 1;
  options.vectors = vectors;
  const SamplePlan plan = PixelPlan(kWidth, kHeight);
  for ([[maybe_unused]] auto _ : state) {
    auto fragments = bench->backend->Render(plan, options);
    if (!fragments) return state.SkipWithError(fragments.error().what.c_str());
    benchmark::DoNotOptimize(*fragments);
  }
  const RayCounts counts = bench->backend->ray_counts();
  state.SetLabel(counts.on_vectors == counts.camera ? "on vectors"
                                                    : "path by path");
  state.counters["rays_per_path"] =
      static_cast<double>(counts.total()) / static_cast<double>(counts.camera);
}

}  // namespace

void RegisterRaytermBenchmarks() {
  benchmark::RegisterBenchmark("rayterm/path", Rayterm, true)
      ->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("rayterm/one_by_one", Rayterm, false)
      ->Unit(benchmark::kMillisecond);
}

}  // namespace rtb
