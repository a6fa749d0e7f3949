/// @file
/// From a prepared scene to fragments by the integrator that the options
/// name, for every backend.
#pragma once

#include <optional>

#include "core/base/check.h"
#include "core/base/result.h"
#include "core/render/path.h"
#include "core/render/plan_renderer.h"
#include "core/render/whitted.h"
#include "core/render/wide/wide_renderer.h"

namespace rtb {

/// The names of the integrators.
inline constexpr const char* kIntegrators = "whitted, path";

/// Success when the options name an integrator that can render the scene.
Status CheckIntegrator(const Scene& scene, const RenderOptions& options);

/// The options' depth, or the scene's.
inline int DepthOf(const Scene& scene, const RenderOptions& options) {
  const int depth =
      options.max_depth >= 0 ? options.max_depth : scene.settings.max_depth;
  RTB_CHECK_LE(depth, kMaxDepth);
  return depth;
}

/// The options' camera, or the scene's at the options' time.
inline CameraFrame CameraOf(const Scene& scene, const RenderOptions& options) {
  return options.camera ? *options.camera : CameraAt(scene, options.time);
}

/// Renders a plan; CheckIntegrator has passed.
/// @tparam Tracer answers what Whitted and PathTracer ask.
template <class Tracer>
Fragments RenderPlan(const Tracer& tracer, const ShadingView& shading,
                     const Scene& scene, const SamplePlan& plan,
                     const RenderOptions& options, RayCounts* counts) {
  const int max_depth = DepthOf(scene, options);
  const CameraFrame camera = CameraOf(scene, options);
  const PlanRenderer renderer(camera, plan, options);
  if (options.integrator == "path") {
    // Vectors are for speed: a tracer that is to be compared has them not.
    if constexpr (requires { tracer.whole_geometry(); }) {
      const bool wanted =
          options.vectors && options.spp <= WideRenderer::kMostRays;
      const auto wide = wanted ? MakeWideScene(tracer.whole_geometry(), shading)
                               : std::nullopt;
      if (wide) {
        return WideRenderer(*wide, camera, plan, options, max_depth)
            .Render(counts);
      }
    }
    return renderer.Render(
        [&] { return PathTracer<Tracer>(tracer, shading, max_depth); }, counts);
  }
  return renderer.Render(
      [&] {
        return Whitted<Tracer>(tracer, shading, max_depth,
                               options.least_weight);
      },
      counts);
}

}  // namespace rtb
