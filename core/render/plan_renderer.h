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
#include "core/render/eye_sample.h"

namespace rtb {

/// Radiance as it may leave the renderer: no NaN, infinity or negative value.
inline float Sanitized(double value) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  if (!(value > 0)) return 0;
  return static_cast<float>(std::min(value, kLargest));
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
    Fragments fragments(plan_);
    std::atomic<std::uint64_t> camera{0}, shadow{0}, secondary{0};
    ParallelFor(plan_.grid.cells(), kCellsPerTask, options_.threads,
                [&](int begin, int end) {
                  const RayCounts own =
                      RenderCells(make_integrator, begin, end, &fragments);
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

  template <class MakeIntegrator>
  RayCounts RenderCells(const MakeIntegrator& make_integrator, int begin,
                        int end, Fragments* fragments) const {
    RayCounts counts;
    auto integrator = make_integrator();
    for (int cell = begin; cell < end; ++cell) {
      const std::span<Rgb> out = fragments->cell(cell);
      for (int s = 0; s < plan_.samples_per_cell; ++s) {
        V3d sum(0);
        for (int ray = 0; ray < options_.spp; ++ray) {
          sum += V3d(integrator.Radiance(EyeSampleAt(cell, s, ray), &counts));
        }
        sum /= options_.spp;
        out[static_cast<std::size_t>(s)] =
            Rgb(Sanitized(sum.x), Sanitized(sum.y), Sanitized(sum.z));
      }
    }
    return counts;
  }

  EyeSample EyeSampleAt(int cell, int sample, int ray) const {
    EyeSample eye;
    eye.pattern =
        RandomBits(static_cast<std::uint32_t>(cell),
                   static_cast<std::uint32_t>(sample), 0, options_.seed);
    eye.index = static_cast<std::uint32_t>(ray);
    eye.seed = options_.seed;
    const V2f jitter = Jitter(eye);
    const V2f& position = plan_.position(cell, sample);
    const GridSize& grid = plan_.grid;
    const double x = cell % grid.columns + double{position.x} + jitter.x;
    const double y = cell / grid.columns + double{position.y} + jitter.y;
    eye.ray = EyeRay(camera_, x / grid.columns, y / grid.rows);
    return eye;
  }

  /// Offset from the sample's position, in cells: none for one ray, else
  /// stratified over the footprint.
  V2f Jitter(const EyeSample& eye) const {
    if (options_.spp == 1) return V2f(0, 0);
    const V2f unit = MultiJittered(
        eye.index, static_cast<std::uint32_t>(options_.spp), eye.pattern);
    return (unit - V2f(0.5f, 0.5f)) * plan_.footprint;
  }

  const CameraRays camera_;
  const SamplePlan& plan_;
  const RenderOptions& options_;
};

}  // namespace rtb
