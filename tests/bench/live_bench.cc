#include <benchmark/benchmark.h>

#include <array>
#include <random>

#include "harness/live/live_setup.h"
#include "harness/live/screen_diff.h"
#include "tests/bench/bench.h"

namespace rtb {
namespace {

constexpr GridSize kScreen{120, 40};

/// Quadrants in random 24-bit colors: every cell differs from the last frame.
CellGrid RandomScreen(std::mt19937* random) {
  constexpr std::array kGlyphs = {U'▀', U'▌', U'▚', U'▞', U'▗', U'▙'};
  const auto color = [random] {
    // Three digits each, the longest there are.
    const auto byte = [random] {
      return static_cast<std::uint8_t>(100 + (*random)() % 156);
    };
    return Rgb8{byte(), byte(), byte()};
  };
  CellGrid screen(kScreen);
  for (Cell& cell : screen.cells) {
    cell = {kGlyphs[(*random)() % kGlyphs.size()], color(), color()};
  }
  return screen;
}

/// What comes after encoding, but for writing the bytes.
void Draw(benchmark::State& state, PresentMode mode) {
  UseUtf8Locale();
  LiveRequest request;
  request.present = mode;
  request.term = "xterm-256color";
  const auto presenter =
      MakePresenter(request, ColorDepth::kTruecolor, kScreen);
  if (!presenter) return state.SkipWithError(presenter.error().what.c_str());
  std::mt19937 random(1);
  std::vector<CellGrid> screens;
  for (int i = 0; i < 8; ++i) screens.push_back(RandomScreen(&random));
  ScreenDiff diff;
  std::size_t next = 0, bytes = 0;
  for ([[maybe_unused]] auto _ : state) {
    const CellGrid& screen = screens[next++ % screens.size()];
    const auto changed = diff.Select(screen, {});
    auto drawn = (*presenter)->Draw({diff.shown(), changed, diff.cleared()});
    if (!drawn) return state.SkipWithError(drawn.error().what.c_str());
    bytes += drawn->size();
  }
  state.counters["bytes_per_frame"] = benchmark::Counter(
      static_cast<double>(bytes), benchmark::Counter::kAvgIterations);
}

}  // namespace

void RegisterLiveBenchmarks() {
  for (const auto& [name, mode] :
       {std::pair{"live/draw/direct", PresentMode::kDirect},
        std::pair{"live/draw/ncurses", PresentMode::kNcurses}}) {
    benchmark::RegisterBenchmark(name, [mode = mode](benchmark::State& state) {
      Draw(state, mode);
    })->Unit(benchmark::kMillisecond);
  }
}

}  // namespace rtb
