#include <benchmark/benchmark.h>

#include <chrono>

#include "encoders/registry.h"
#include "tests/bench/bench.h"

namespace rtb {
namespace {

constexpr GridSize kGrid{120, 40};
constexpr double kCellAspect = 0.5;

/// The samples of a real picture: the Cornell box, as the encoder asks.
Result<Fragments> CornellFragments(const Encoder& encoder) {
  RTB_ASSIGN_OR_RETURN(const BenchScene cornell, LoadBenchScene("cornell"));
  return cornell.backend->Render(encoder.Plan(kGrid, kCellAspect, 0), {});
}

void Encode(benchmark::State& state, const std::string& spec) {
  const auto encoder = MakeEncoder(spec);
  if (!encoder) return state.SkipWithError(encoder.error().what.c_str());
  const auto fragments = CornellFragments(**encoder);
  if (!fragments) return state.SkipWithError(fragments.error().what.c_str());
  const auto start = std::chrono::steady_clock::now();
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize((*encoder)->Encode(*fragments, {}));
  }
  const std::chrono::duration<double, std::nano> took =
      std::chrono::steady_clock::now() - start;
  state.counters["ns_per_cell"] =
      took.count() / static_cast<double>(state.iterations()) / kGrid.cells();
}

}  // namespace

void RegisterEncodeBenchmarks() {
  for (const EncoderEntry& entry : EncoderEntries()) {
    const std::string& spec = entry.info.name;
    benchmark::RegisterBenchmark(
        ("encode/" + spec).c_str(),
        [spec](benchmark::State& state) { Encode(state, spec); })
        ->UseRealTime()
        ->Unit(benchmark::kMicrosecond);
  }
}

}  // namespace rtb
