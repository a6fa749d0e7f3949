#include <benchmark/benchmark.h>

#include "tests/bench/bench.h"

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  rtb::RegisterEncodeBenchmarks();
  rtb::RegisterAdaptiveBenchmarks();
  rtb::RegisterRenderBenchmarks();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
