#include <benchmark/benchmark.h>

#include <chrono>

#include "encoders/registry.h"
#include "tests/bench/bench.h"

namespace rtb {
namespace {

constexpr GridSize kGrid{120, 40};
constexpr double kCellAspect = 0.5;

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

/// Renders, and adds up how long that takes.
class TimedSource : public FragmentSource {
 public:
  explicit TimedSource(Backend& backend) : backend_(backend) {}

  Result<Fragments> Query(const SamplePlan& plan) override {
    const auto start = Clock::now();
    auto fragments = backend_.Render(plan, {});
    spent_ += Clock::now() - start;
    return fragments;
  }

  Seconds spent() const { return spent_; }

 private:
  Backend& backend_;
  Seconds spent_{0};
};

/// What one run takes beside rendering.
Result<Seconds> TimeRun(const Encoder& encoder, Backend& backend) {
  TimedSource source(backend);
  const auto start = Clock::now();
  RTB_ASSIGN_OR_RETURN(const Encoding encoding,
                       encoder.Run(source, kGrid, kCellAspect, {}));
  const Seconds took = Clock::now() - start;
  benchmark::DoNotOptimize(encoding.grid.cells.data());
  return took - source.spent();
}

void Encode(benchmark::State& state, const std::string& spec) {
  const auto encoder = MakeEncoder(spec);
  if (!encoder) return state.SkipWithError(encoder.error().what.c_str());
  // Samples of a real picture.
  const auto cornell = LoadBenchScene("cornell");
  if (!cornell) return state.SkipWithError(cornell.error().what.c_str());
  Seconds total{0};
  for ([[maybe_unused]] auto _ : state) {
    const auto took = TimeRun(**encoder, *cornell->backend);
    if (!took) return state.SkipWithError(took.error().what.c_str());
    state.SetIterationTime(took->count());
    total += *took;
  }
  state.counters["ns_per_cell"] = 1e9 * total.count() /
                                  static_cast<double>(state.iterations()) /
                                  kGrid.cells();
}

}  // namespace

void RegisterEncodeBenchmarks() {
  for (const EncoderEntry& entry : EncoderEntries()) {
    const std::string& spec = entry.info.name;
    benchmark::RegisterBenchmark(
        ("encode/" + spec).c_str(),
        [spec](benchmark::State& state) { Encode(state, spec); })
        ->UseManualTime()
        ->Unit(benchmark::kMicrosecond);
  }
}

}  // namespace rtb
