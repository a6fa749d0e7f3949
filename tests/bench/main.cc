#include <benchmark/benchmark.h>
#include <hwy/highway.h>
#include <malloc.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string_view>

#include "tests/bench/bench.h"

namespace {

/// Takes `--simd=TARGET`, e.g. AVX2: the instruction set of the encoders in
/// place of the best one. Exits where there is no such target.
void ChooseSimd(int& argc, char** argv) {
  constexpr std::string_view kOption = "--simd=";
  if (argc < 2 || !std::string_view(argv[1]).starts_with(kOption)) return;
  const std::string_view name =
      std::string_view(argv[1]).substr(kOption.size());
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    if (hwy::TargetName(target) != name) continue;
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(target);
    std::copy(argv + 2, argv + argc, argv + 1);
    argv[--argc] = nullptr;
    return;
  }
  std::cerr << "no target " << name << " here; there are:";
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    std::cerr << " " << hwy::TargetName(target);
  }
  std::cerr << "\n";
  std::exit(2);
}

}  // namespace

int main(int argc, char** argv) {
  // Memory once taken is kept: page faults are no part of encoding.
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
  mallopt(M_MMAP_THRESHOLD, 1 << 30);
  ChooseSimd(argc, argv);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  rtb::RegisterEncodeBenchmarks();
  rtb::RegisterAdaptiveBenchmarks();
  rtb::RegisterRenderBenchmarks();
  rtb::RegisterRaytermBenchmarks();
  rtb::RegisterBvhBenchmarks();
  rtb::RegisterLiveBenchmarks();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
