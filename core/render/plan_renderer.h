/// @file
/// PlanRenderer: from a sample plan to fragments, for every backend.
#pragma once

#include <cstddef>
#include <mutex>
#include <span>

#include "core/base/parallel.h"
#include "core/render/backend.h"
#include "core/render/render_sample.h"

namespace rtb {

/// All fragments of a plan, some entries to a task; results do not depend on
/// how many. `counts` receives the rays traced.
/// @param render_entries called with (begin, end, fragments) by many threads;
/// returns the rays that it traced.
template <class RenderEntries>
Fragments RenderInTasks(const SamplePlan& plan, const RenderOptions& options,
                        const RenderEntries& render_entries,
                        RayCounts* counts) {
  constexpr int kEntriesPerTask = 64;
  Fragments fragments(plan);
  RayCounts all;
  std::mutex guard;
  if (options.spp > 1) fragments.variances.resize(plan.samples());
  ParallelFor(plan.entries(), kEntriesPerTask, options.threads,
              [&](int begin, int end) {
                const RayCounts own = render_entries(begin, end, &fragments);
                const std::lock_guard lock(guard);
                all += own;
              });
  *counts = all;
  return fragments;
}

/// Renders the samples of one plan.
class PlanRenderer {
 public:
  /// The plan and the options must outlive the renderer.
  PlanRenderer(const CameraFrame& camera, const SamplePlan& plan,
               const RenderOptions& options)
      : rays_{MakeCameraRays(camera, plan.aspect()), ViewOf(plan), options.spp,
              options.seed},
        plan_(plan),
        options_(options) {}

  /// All fragments; `counts` receives the rays traced.
  /// @param make_integrator returns what answers Radiance(eye, counts); each
  /// task makes one of its own.
  template <class MakeIntegrator>
  Fragments Render(const MakeIntegrator& make_integrator,
                   RayCounts* counts) const {
    return RenderInTasks(
        plan_, options_,
        [&](int begin, int end, Fragments* fragments) {
          return RenderEntries(make_integrator, begin, end, fragments);
        },
        counts);
  }

 private:
  template <class MakeIntegrator>
  RayCounts RenderEntries(const MakeIntegrator& make_integrator, int begin,
                          int end, Fragments* fragments) const {
    RayCounts counts;
    auto integrator = make_integrator();
    for (int entry = begin; entry < end; ++entry) {
      const std::span<Rgb> out = fragments->cell(entry);
      for (int s = 0; s < plan_.samples_per_cell; ++s) {
        const MeanOfRays rays =
            RenderSample(rays_, integrator, entry, s, &counts);
        out[static_cast<std::size_t>(s)] = rays.Mean();
        if (!fragments->variances.empty()) {
          fragments->variances[static_cast<std::size_t>(
              entry * plan_.samples_per_cell + s)] = rays.Variance();
        }
      }
    }
    return counts;
  }

  const PlanRays rays_;
  const SamplePlan& plan_;
  const RenderOptions& options_;
};

}  // namespace rtb
