/// @file
/// PlanRenderer: from a sample plan to fragments, for every backend.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <mutex>

#include "core/base/parallel.h"
#include "core/math/random.h"
#include "core/math/sampling.h"
#include "core/render/backend.h"
#include "core/render/camera_rays.h"
#include "core/render/eye_sample.h"

namespace rtb {

/// Radiance as it may leave the renderer: no NaN, infinity or negative value.
inline float Sanitized(double value) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  if (!(value > 0)) return 0;
  return static_cast<float>(std::min(value, kLargest));
}

/// Gathers the rays of one sample.
class MeanOfRays {
 public:
  void Add(const V3d& radiance) {
    ++count_;
    sum_ += radiance;
    squares_ += radiance * radiance;
  }

  Rgb Mean() const {
    const V3d mean = sum_ / count_;
    return {Sanitized(mean.x), Sanitized(mean.y), Sanitized(mean.z)};
  }

  /// Of the mean, as if the rays were independent; mean over the channels. 0
  /// for one ray.
  float Variance() const {
    if (count_ < 2) return 0;
    const V3d spread = squares_ - sum_ * sum_ / count_;
    return Sanitized((spread.x + spread.y + spread.z) /
                     (3.0 * count_ * (count_ - 1)));
  }

 private:
  int count_ = 0;
  V3d sum_{0};
  V3d squares_{0};
};

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
  /// All references must outlive the renderer.
  PlanRenderer(const CameraFrame& camera, const SamplePlan& plan,
               const RenderOptions& options)
      : camera_(MakeCameraRays(camera, plan.aspect())),
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
        const MeanOfRays rays = RenderSample(integrator, entry, s, &counts);
        out[static_cast<std::size_t>(s)] = rays.Mean();
        if (!fragments->variances.empty()) {
          fragments->variances[static_cast<std::size_t>(
              entry * plan_.samples_per_cell + s)] = rays.Variance();
        }
      }
    }
    return counts;
  }

  template <class Integrator>
  MeanOfRays RenderSample(Integrator& integrator, int entry, int sample,
                          RayCounts* counts) const {
    EyeSample eye;
    eye.pattern =
        RandomBits(static_cast<std::uint32_t>(plan_.cell(entry)),
                   static_cast<std::uint32_t>(plan_.number(entry, sample)), 0,
                   options_.seed);
    eye.seed = options_.seed;
    MeanOfRays rays;
    if (options_.spp == 1) {
      eye.ray = RayThrough(entry, sample, V2f(0, 0));
      rays.Add(V3d(integrator.Radiance(eye, counts)));
      return rays;
    }
    // Stratified over the footprint.
    const MultiJitter jitter(static_cast<std::uint32_t>(options_.spp),
                             eye.pattern);
    for (int ray = 0; ray < options_.spp; ++ray) {
      eye.index = static_cast<std::uint32_t>(ray);
      const V2f unit = jitter.At(eye.index);
      eye.ray =
          RayThrough(entry, sample, (unit - V2f(0.5f, 0.5f)) * plan_.footprint);
      rays.Add(V3d(integrator.Radiance(eye, counts)));
    }
    return rays;
  }

  /// The ray through a sample's position.
  /// @param offset from there, in cells.
  Ray RayThrough(int entry, int sample, const V2f& offset) const {
    const int cell = plan_.cell(entry);
    const V2f& position = plan_.position(entry, sample);
    const GridSize& grid = plan_.grid;
    const double x = cell % grid.columns + double{position.x} + offset.x;
    const double y = cell / grid.columns + double{position.y} + offset.y;
    return EyeRay(camera_, x / grid.columns, y / grid.rows);
  }

  const CameraRays camera_;
  const SamplePlan& plan_;
  const RenderOptions& options_;
};

}  // namespace rtb
