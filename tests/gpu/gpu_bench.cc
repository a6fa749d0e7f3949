// Frames and rays a second of the backend cuda, for every canonical scene at
// 240 x 67 cells of 32 samples: JSON on standard output. Exit status 3 where no
// GPU can be used; no figure is printed that none produced.
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "core/render/cuda_backend.h"
#include "core/scene/load.h"
#include "tests/gpu/gpu_scenes.h"

namespace rtb {
namespace {

using Clock = std::chrono::steady_clock;
using Json = nlohmann::ordered_json;

constexpr int kWarmUpFrames = 5;
constexpr double kSeconds = 1;

/// What frames took; two are under way at any time.
struct Pace {
  double frames_per_second = 0;
  double mrays_per_second = 0;
};

/// @param step seconds of the scene from frame to frame; 0 = it stands still.
Result<Pace> Measure(AheadBackend& cuda, const SamplePlan& plan, double step) {
  RenderOptions options;
  Clock::time_point start;
  double seconds = 0;
  std::uint64_t rays = 0;
  int frames = 0;
  RTB_RETURN_IF_ERROR(cuda.Submit(plan, options));
  for (int i = 1; seconds < kSeconds; ++i) {
    options.time = step * i;
    RTB_RETURN_IF_ERROR(cuda.Submit(plan, options));
    RTB_ASSIGN_OR_RETURN(const Fragments fragments, cuda.Collect());
    if (i == kWarmUpFrames) start = Clock::now();
    if (i <= kWarmUpFrames) continue;
    ++frames;
    rays += cuda.ray_counts().total();
    seconds = std::chrono::duration<double>(Clock::now() - start).count();
  }
  RTB_ASSIGN_OR_RETURN(const Fragments last, cuda.Collect());
  return Pace{frames / seconds, static_cast<double>(rays) / seconds / 1e6};
}

Result<Json> MeasureScene(const std::string& name, const SamplePlan& plan) {
  RTB_ASSIGN_OR_RETURN(const Scene scene,
                       LoadScene(testing::CanonicalScene(name)));
  RTB_ASSIGN_OR_RETURN(const auto cuda, MakeCudaBackend(scene));
  RTB_ASSIGN_OR_RETURN(const Pace still, Measure(*cuda, plan, 0));
  RTB_ASSIGN_OR_RETURN(const Pace moving, Measure(*cuda, plan, 1.0 / 60));
  return Json{{"scene", name},
              {"frames_per_second", still.frames_per_second},
              {"mrays_per_second", still.mrays_per_second},
              {"moving_frames_per_second", moving.frames_per_second},
              {"moving_mrays_per_second", moving.mrays_per_second}};
}

int Run() {
  const auto device = CudaDeviceName();
  if (!device) {
    std::fprintf(stderr, "gpu_bench: %s\n", device.error().ToString().c_str());
    return static_cast<int>(device.error().kind);
  }
  const SamplePlan plan = RegularPlan({240, 67}, 4, 8);
  Json scenes = Json::array();
  for (const std::string& name : testing::CanonicalScenes()) {
    const auto measured = MeasureScene(name, plan);
    if (!measured) {
      std::fprintf(stderr, "gpu_bench: %s: %s\n", name.c_str(),
                   measured.error().ToString().c_str());
      return static_cast<int>(measured.error().kind);
    }
    scenes.push_back(*measured);
  }
  const Json all = {{"schema", 1},
                    {"device", *device},
                    {"grid", {240, 67}},
                    {"samples_per_cell", 32},
                    {"scenes", scenes}};
  std::puts(all.dump(2).c_str());
  return 0;
}

}  // namespace
}  // namespace rtb

int main() { return rtb::Run(); }
