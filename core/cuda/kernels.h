/// @file
/// The bodies of the CUDA backend's kernels, one call a thread. They are plain
/// host and device code: tests run them on the CPU too.
#pragma once

#include <cstddef>

#include "core/accel/bvh_tracer.h"
#include "core/accel/bvh_view.h"
#include "core/base/host_device.h"
#include "core/math/vec.h"
#include "core/render/path.h"
#include "core/render/ray_counts.h"
#include "core/render/render_sample.h"
#include "core/render/whitted.h"
#include "core/shading/shading_scene.h"

namespace rtb {

/// What the kernels that render are given. All pointers are the device's.
struct RenderJob {
  PlanRays rays;
  BvhView scene;
  ShadingView shading;
  int max_depth = 0;
  float least_weight = 0;       ///< Of whitted.
  Rgb* values = nullptr;        ///< One for each sample.
  float* variances = nullptr;   ///< The same; null for one ray a sample.
  RayCounts* counts = nullptr;  ///< The same.
};

/// Renders sample `index` of the job's plan; none where there are fewer.
template <class Integrator>
RTB_HD void RenderOne(const RenderJob& job, std::size_t index,
                      Integrator& integrator) {
  const auto samples = static_cast<std::size_t>(job.rays.plan.samples_per_cell);
  // Counted where they are stored: registers are scarce.
  RayCounts* counts = &job.counts[index];
  *counts = RayCounts{};
  const MeanOfRays rays =
      RenderSample(job.rays, integrator, static_cast<int>(index / samples),
                   static_cast<int>(index % samples), counts);
  job.values[index] = rays.Mean();
  if (job.variances != nullptr) job.variances[index] = rays.Variance();
}

/// @name The kernels by integrator: sample `index`.
/// @{
RTB_HD inline void RenderWhitted(const RenderJob& job, std::size_t index) {
  if (index >= job.rays.plan.samples()) return;
  const BvhTracer tracer(job.scene);
  Whitted<BvhTracer> integrator(tracer, job.shading, job.max_depth,
                                job.least_weight);
  RenderOne(job, index, integrator);
}
RTB_HD inline void RenderPath(const RenderJob& job, std::size_t index) {
  if (index >= job.rays.plan.samples()) return;
  const BvhTracer tracer(job.scene);
  PathTracer<BvhTracer> integrator(tracer, job.shading, job.max_depth);
  RenderOne(job, index, integrator);
}
/// @}

/// Counts to be summed: `sums[k]` receives every sum_count-th, from k on.
struct SumJob {
  const RayCounts* counts = nullptr;
  std::size_t count = 0;
  RayCounts* sums = nullptr;
  std::size_t sum_count = 0;
};

/// Sum `index` of the job's; none where there are fewer.
RTB_HD inline void SumCounts(const SumJob& job, std::size_t index) {
  if (index >= job.sum_count) return;
  RayCounts sum;
  for (std::size_t i = index; i < job.count; i += job.sum_count) {
    sum += job.counts[i];
  }
  job.sums[index] = sum;
}

}  // namespace rtb
