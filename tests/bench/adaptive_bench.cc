#include <benchmark/benchmark.h>

#include "encoders/adaptive/tracer.h"
#include "tests/bench/bench.h"
#include "tests/bench/encode_timer.h"

namespace rtb {
namespace {

/// Renders on one thread, and adds up how long that takes.
class TimedBackend : public FragmentSource {
 public:
  explicit TimedBackend(Backend& backend) : backend_(backend) {
    options_.threads = 1;
  }

  Result<Fragments> Query(const SamplePlan& plan) override {
    const double start = ThreadSeconds();
    auto fragments = backend_.Render(plan, options_);
    spent_ += ThreadSeconds() - start;
    return fragments;
  }

  double spent_seconds() const { return spent_; }

 private:
  Backend& backend_;
  RenderOptions options_;
  double spent_ = 0;
};

/// Chooses and traces all rays of one picture.
void Choose(benchmark::State& state, const std::string& scene) {
  const auto bench = LoadBenchScene(scene);
  if (!bench) return state.SkipWithError(bench.error().what.c_str());
  TraceRequest request;
  request.grid = kBenchGrid;
  request.threads = 1;
  double choosing = 0;
  double tracing = 0;
  for ([[maybe_unused]] auto _ : state) {
    TimedBackend source(*bench->backend);
    const double start = ThreadSeconds();
    const auto samples = TraceAdaptively(source, request);
    if (!samples) return state.SkipWithError(samples.error().what.c_str());
    const double all = ThreadSeconds() - start;
    state.SetIterationTime(all);
    tracing += source.spent_seconds();
    choosing += all - source.spent_seconds();
  }
  const auto runs = static_cast<double>(state.iterations());
  state.counters["choose_ms"] = 1e3 * choosing / runs;
  state.counters["trace_ms"] = 1e3 * tracing / runs;
  state.counters["share"] = choosing / tracing;
}

}  // namespace

void RegisterAdaptiveBenchmarks() {
  for (const std::string scene :
       {"bump", "cornell", "cornell-area", "explore", "glass", "lambertian",
        "metal", "moving", "shadow", "tessellation", "whitted"}) {
    benchmark::RegisterBenchmark(
        ("adaptive/choose/" + scene).c_str(),
        [scene](benchmark::State& state) { Choose(state, scene); })
        ->UseManualTime()
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace rtb
