#include <benchmark/benchmark.h>

#include <optional>

#include "encoders/parameters.h"
#include "encoders/registry.h"
#include "encoders/simd/kernels.h"
#include "tests/bench/bench.h"
#include "tests/bench/encode_timer.h"

namespace rtb {
namespace {

/// Median time of libchafa's encoder, where the program has one.
std::optional<double> ChafaSeconds() {
  static const std::optional<double> seconds = []() -> std::optional<double> {
    const auto encoder = MakeEncoder("chafa");
    if (!encoder) return std::nullopt;
    const auto timer = EncodeTimer::Make(**encoder);
    if (!timer) return std::nullopt;
    Samples samples;
    for (int i = 0; i < 5; ++i) {
      const auto took = (*timer)->Run(false);
      if (!took) return std::nullopt;
      samples.Add(*took);
    }
    return samples.Median();
  }();
  return seconds;
}

void Report(benchmark::State& state, const Samples& fast, const Samples& scalar,
            const std::string& input) {
  state.counters["ns_per_cell"] = 1e9 * fast.Median() / kBenchGrid.cells();
  state.counters["ns_per_cell_min"] = 1e9 * fast.Least() / kBenchGrid.cells();
  state.counters["ratio_to_scalar"] = scalar.Median() / fast.Median();
  if (const auto chafa = ChafaSeconds()) {
    state.counters["ratio_to_chafa"] = *chafa / fast.Median();
  }
  state.SetLabel(std::string(SimdTargetName()) + ", " + input + ", in cache");
}

/// Times vectors and the scalar version in turn; the first is the benchmark's
/// time, or the second for the twin.
void Encode(benchmark::State& state, const std::string& spec, bool twin) {
  const auto encoder = MakeEncoder(spec);
  if (!encoder) return state.SkipWithError(encoder.error().what.c_str());
  const auto timer = EncodeTimer::Make(**encoder);
  if (!timer) return state.SkipWithError(timer.error().what.c_str());
  Samples samples[2];
  for ([[maybe_unused]] auto _ : state) {
    for (const bool scalar : {false, true}) {
      const auto took = (*timer)->Run(scalar);
      if (!took) return state.SkipWithError(took.error().what.c_str());
      samples[scalar].Add(*took);
      if (scalar == twin) state.SetIterationTime(*took);
    }
  }
  Report(state, samples[twin], samples[1], "linear float");
}

void Register(const std::string& spec) {
  for (const bool twin : {false, true}) {
    const std::string group = twin ? "scalar/" : "encode/";
    benchmark::RegisterBenchmark(
        (group + spec).c_str(),
        [spec, twin](benchmark::State& state) { Encode(state, spec, twin); })
        ->UseManualTime()
        ->Unit(benchmark::kMicrosecond);
  }
}

}  // namespace

void RegisterEncodeBenchmarks() {
  for (const EncoderEntry& entry : EncoderEntries()) {
    Register(entry.info.name);
    for (const EncoderParameter& parameter : entry.info.parameters) {
      if (parameter.values.find('|') == std::string::npos) continue;
      for (const std::string& value : ChoiceNames(parameter)) {
        if (value == parameter.default_value) continue;
        Register(entry.info.name + ":" + parameter.name + "=" + value);
      }
    }
  }
}

}  // namespace rtb
