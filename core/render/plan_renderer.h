/// @file
/// PlanRenderer: from a sample plan to fragments, for every backend.
#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/base/parallel.h"
#include "core/math/random.h"
#include "core/math/sampling.h"
#include "core/render/backend.h"
#include "core/render/camera_rays.h"
#include "core/render/whitted.h"
#include "core/shading/shading_scene.h"

namespace rtb {

/// Radiance as it may leave the renderer: no NaN, infinity or negative value.
inline float Sanitized(double value) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  if (!(value > 0)) return 0;
  return static_cast<float>(std::min(value, kLargest));
}

/// Renders the samples of one plan.
/// @tparam Tracer see Whitted.
template <class Tracer>
class PlanRenderer {
 public:
  /// All references must outlive the renderer.
  PlanRenderer(const Tracer& tracer, const ShadingView& shading,
               const CameraFrame& camera, const SamplePlan& plan,
               const RenderOptions& options, int max_depth)
      : tracer_(tracer),
        shading_(shading),
        camera_(MakeCameraRays(camera, plan.aspect())),
        plan_(plan),
        options_(options),
        max_depth_(max_depth) {}

  /// All fragments; `counts` receives the rays traced.
  Fragments Render(RayCounts* counts) const {
    Fragments fragments(plan_);
    std::atomic<std::uint64_t> camera{0}, shadow{0}, secondary{0};
    ParallelFor(plan_.grid.cells(), kCellsPerTask, options_.threads,
                [&](int begin, int end) {
                  const RayCounts own = RenderCells(begin, end, &fragments);
                  camera += own.camera;
                  shadow += own.shadow;
                  secondary += own.secondary;
                });
    *counts = {camera, shadow, secondary};
    return fragments;
  }

 private:
  /// Cells that one task renders; results do not depend on it.
  static constexpr int kCellsPerTask = 64;

  RayCounts RenderCells(int begin, int end, Fragments* fragments) const {
    RayCounts counts;
    Whitted<Tracer> integrator(tracer_, shading_, max_depth_);
    for (int cell = begin; cell < end; ++cell) {
      const std::span<Rgb> out = fragments->cell(cell);
      for (int s = 0; s < plan_.samples_per_cell; ++s) {
        V3d sum(0);
        for (int ray = 0; ray < options_.spp; ++ray) {
          sum += V3d(integrator.Radiance(CameraRay(cell, s, ray), &counts));
        }
        sum /= options_.spp;
        out[static_cast<std::size_t>(s)] =
            Rgb(Sanitized(sum.x), Sanitized(sum.y), Sanitized(sum.z));
      }
    }
    return counts;
  }

  Ray CameraRay(int cell, int sample, int ray) const {
    const V2f jitter = Jitter(cell, sample, ray);
    const V2f& position = plan_.position(cell, sample);
    const GridSize& grid = plan_.grid;
    const double x = cell % grid.columns + double{position.x} + jitter.x;
    const double y = cell / grid.columns + double{position.y} + jitter.y;
    return EyeRay(camera_, x / grid.columns, y / grid.rows);
  }

  /// Offset from the sample's position, in cells: none for one ray, else
  /// stratified over the footprint.
  V2f Jitter(int cell, int sample, int ray) const {
    if (options_.spp == 1) return V2f(0, 0);
    const std::uint32_t pattern =
        RandomBits(static_cast<std::uint32_t>(cell),
                   static_cast<std::uint32_t>(sample), 0, options_.seed);
    const V2f unit =
        MultiJittered(static_cast<std::uint32_t>(ray),
                      static_cast<std::uint32_t>(options_.spp), pattern);
    return (unit - V2f(0.5f, 0.5f)) * plan_.footprint;
  }

  const Tracer& tracer_;
  const ShadingView shading_;
  const CameraRays camera_;
  const SamplePlan& plan_;
  const RenderOptions& options_;
  const int max_depth_;
};

}  // namespace rtb
