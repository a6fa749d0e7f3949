#include "core/render/wide/wide_renderer.h"

#include <algorithm>

#include "core/math/random.h"
#include "core/render/wide/eye_rays.h"

namespace rtb {
namespace {

/// Where a renderer is in a plan: ray `ray` of one of its samples.
struct Place {
  std::size_t sample = 0;  ///< Among all of the plan.
  int ray = 0;
};

EyeSet EyesOf(const SamplePlan& plan, const RenderOptions& options,
              std::size_t number) {
  const auto samples = static_cast<std::size_t>(plan.samples_per_cell);
  const auto entry = static_cast<int>(number / samples);
  const auto sample = static_cast<int>(number % samples);
  const int cell = plan.cell(entry);
  const V2f& position = plan.position(entry, sample);
  EyeSet set;
  set.pattern = RandomBits(
      static_cast<std::uint32_t>(cell),
      static_cast<std::uint32_t>(plan.number(entry, sample)), 0, options.seed);
  set.count = static_cast<std::uint32_t>(options.spp);
  set.position = V2d(cell % plan.grid.columns + double{position.x},
                     cell / plan.grid.columns + double{position.y});
  set.footprint = plan.footprint;
  return set;
}

}  // namespace

Fragments WideRenderer::Render(RayCounts* counts) const {
  return RenderInTasks(
      plan_, options_,
      [this](int begin, int end, Fragments* fragments) {
        return RenderEntries(begin, end, fragments);
      },
      counts);
}

RayCounts WideRenderer::RenderEntries(int begin, int end,
                                      Fragments* fragments) const {
  const auto samples = static_cast<std::size_t>(plan_.samples_per_cell);
  const std::size_t last = static_cast<std::size_t>(end) * samples;
  Place place{static_cast<std::size_t>(begin) * samples, 0};
  RayCounts counts;
  MeanOfRays mean;
  Paths paths;
  while (place.sample < last) {
    const Place first = place;
    paths.count = 0;
    while (place.sample < last && paths.count < Paths::kMost) {
      const int count =
          std::min(options_.spp - place.ray, Paths::kMost - paths.count);
      PlaceEyes(EyesOf(plan_, options_, place.sample),
                static_cast<std::uint32_t>(place.ray), count, paths.count,
                &paths);
      paths.count += count;
      place.ray += count;
      if (place.ray == options_.spp) place = {place.sample + 1, 0};
    }
    const int count = paths.count;
    MakeEyeRays(camera_, plan_.grid, &paths);
    TracePaths(scene_, options_.seed, max_depth_, &paths, &counts);
    Gather(first.sample, first.ray, count, paths, &mean, fragments);
  }
  return counts;
}

void WideRenderer::Gather(std::size_t sample, int ray, int count,
                          const Paths& paths, MeanOfRays* mean,
                          Fragments* fragments) const {
  for (int i = 0; i < count; ++i) {
    mean->Add(V3d(paths.result[0][i], paths.result[1][i], paths.result[2][i]));
    if (++ray < options_.spp) continue;
    fragments->values[sample] = mean->Mean();
    if (!fragments->variances.empty()) {
      fragments->variances[sample] = mean->Variance();
    }
    ++sample;
    ray = 0;
    *mean = {};
  }
}

}  // namespace rtb
