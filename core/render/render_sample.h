/// @file
/// RenderSample: from one sample of a plan to its radiance. These lines run
/// on every backend, host and device.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "core/base/host_device.h"
#include "core/math/random.h"
#include "core/math/sampling.h"
#include "core/render/camera_rays.h"
#include "core/render/eye_sample.h"
#include "core/render/mean_of_rays.h"
#include "core/render/plan_view.h"
#include "core/render/ray_counts.h"

namespace rtb {

/// A plan as a camera sees it.
struct PlanRays {
  CameraRays camera;  ///< Of the plan's aspect.
  PlanView plan;
  int spp = 1;  ///< Rays per sample; 1 = its point, no jitter.
  std::uint64_t seed = 0;
};

/// The ray through a sample's position.
/// @param offset from there, in cells.
RTB_HD inline Ray RayThrough(const PlanRays& rays, int entry, int sample,
                             const V2f& offset) {
  const PlanView& plan = rays.plan;
  const int cell = plan.cell(entry);
  const V2f& position = plan.position(entry, sample);
  const double x = cell % plan.columns + double{position.x} + offset.x;
  const double y = cell / plan.columns + double{position.y} + offset.y;
  return EyeRay(rays.camera, x / plan.columns, y / plan.rows);
}

/// One of the parts into which a sample's rays divide its beam.
RTB_HD inline RayCone ConeOf(const PlanRays& rays, const Ray& ray) {
  const PlanView& plan = rays.plan;
  const double share = 1 / std::sqrt(static_cast<double>(rays.spp));
  return {0, SpreadOf(rays.camera, share * plan.beam.x / plan.columns,
                      share * plan.beam.y / plan.rows, ray.direction)};
}

/// Ray `index` of those that are stratified over a sample's footprint.
RTB_HD_CALLED inline Ray JitteredRay(const PlanRays& rays,
                                     const MultiJitter& jitter, int entry,
                                     int sample, std::uint32_t index) {
  const V2f unit = jitter.At(index);
  return RayThrough(rays, entry, sample,
                    (unit - V2f(0.5f, 0.5f)) * rays.plan.footprint);
}

/// Traces the rays of one sample.
/// @tparam Integrator answers Radiance(eye, counts).
template <class Integrator>
RTB_HD MeanOfRays RenderSample(const PlanRays& rays, Integrator& integrator,
                               int entry, int sample, RayCounts* counts) {
  const PlanView& plan = rays.plan;
  EyeSample eye;
  eye.pattern = RandomBits(
      static_cast<std::uint32_t>(plan.cell(entry)),
      static_cast<std::uint32_t>(plan.number(entry, sample)), 0, rays.seed);
  eye.seed = rays.seed;
  std::optional<MultiJitter> jitter;
  if (rays.spp > 1) {
    jitter.emplace(static_cast<std::uint32_t>(rays.spp), eye.pattern);
  }
  MeanOfRays mean;
  // One call of the integrator, whose device code is large.
  for (int ray = 0; ray < rays.spp; ++ray) {
    eye.index = static_cast<std::uint32_t>(ray);
    eye.ray = jitter ? JitteredRay(rays, *jitter, entry, sample, eye.index)
                     : RayThrough(rays, entry, sample, V2f(0, 0));
    eye.cone = ConeOf(rays, eye.ray);
    mean.Add(V3d(integrator.Radiance(eye, counts)));
  }
  return mean;
}

}  // namespace rtb
