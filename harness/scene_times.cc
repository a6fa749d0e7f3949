#include "harness/scene_times.h"

#include "core/scene/load.h"
#include "harness/stopwatch.h"

namespace rtb {
namespace {

/// One preparation. The backend composes the scene and builds its accelerator
/// when the first ray is asked for.
Status PrepareOnce(const PreparedScene& prepared, Cost& load, Cost& build) {
  const Stopwatch stopwatch;
  RTB_ASSIGN_OR_RETURN(const Scene scene, LoadScene(prepared.file));
  load = stopwatch.Read();
  RenderOptions options = prepared.options;
  options.spp = 1;
  RTB_ASSIGN_OR_RETURN(const std::unique_ptr<Backend> backend,
                       MakeBackend(prepared.backend->name(), scene));
  const auto ray = backend->Render(PixelPlan(1, 1), options);
  if (!ray) return Fail(ray.error());
  build = stopwatch.Read() - load;
  return {};
}

}  // namespace

Result<SceneTimes> TimeScene(const PreparedScene& scene, int warm_ups,
                             int repeat) {
  SceneTimes times;
  for (int i = 0; i < warm_ups + repeat; ++i) {
    Cost load, build;
    RTB_RETURN_IF_ERROR(PrepareOnce(scene, load, build));
    if (i < warm_ups) continue;
    AddTime(load, times.load);
    AddTime(build, times.build);
  }
  return times;
}

}  // namespace rtb
