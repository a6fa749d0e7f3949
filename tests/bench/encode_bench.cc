#include <benchmark/benchmark.h>

#include <optional>

#include "encoders/parameters.h"
#include "encoders/registry.h"
#include "encoders/simd/kernels.h"
#include "encoders/tiv_cell.h"
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

/// The canonical grid's pixels for encoder `tiv`, of the Cornell box.
Result<std::vector<Rgb8>> TivPixels() {
  RTB_ASSIGN_OR_RETURN(const auto source, RecordedSource::Make());
  RTB_ASSIGN_OR_RETURN(
      const Fragments fragments,
      source->Query(RegularPlan(kBenchGrid, kTivColumns, kTivRows, 0.5)));
  std::vector<Rgb8> pixels(fragments.values.size());
  Encode8(fragments.values, pixels);
  return pixels;
}

void EncodeTivScalar(std::span<const Rgb8> pixels, std::span<Cell> cells) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    cells[i] = TivCell(std::span<const Rgb8, kTivPixels>(
        pixels.subspan(i * kTivPixels, kTivPixels)));
  }
}

/// `tiv` from 8-bit pixels, as other programs take them.
void EncodeTiv8(benchmark::State& state) {
  const auto pixels = TivPixels();
  if (!pixels) return state.SkipWithError(pixels.error().what.c_str());
  CellGrid grid(kBenchGrid);
  Samples samples[2];
  for ([[maybe_unused]] auto _ : state) {
    for (const bool scalar : {false, true}) {
      const double start = ThreadSeconds();
      (scalar ? EncodeTivScalar : EncodeTivCells)(*pixels, grid.cells);
      const double took = ThreadSeconds() - start;
      benchmark::DoNotOptimize(grid.cells.data());
      samples[scalar].Add(took);
      if (!scalar) state.SetIterationTime(took);
    }
  }
  Report(state, samples[0], samples[1], "8-bit");
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
  benchmark::RegisterBenchmark("encode_8bit/tiv", EncodeTiv8)
      ->UseManualTime()
      ->Unit(benchmark::kMicrosecond);
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
  Register("optimal:mask=8x8");
  Register("optimal:glyphs=blocks+quadrants+eighths+sextants+octants+wedges");
}

}  // namespace rtb
