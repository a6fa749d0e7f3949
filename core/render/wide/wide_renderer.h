/// @file
/// WideRenderer: from a sample plan to fragments by the path integrator on
/// vectors of paths.
#pragma once

#include <memory>

#include "core/render/plan_renderer.h"
#include "core/render/wide/trace_paths.h"
#include "core/render/wide/wide_scene.h"

namespace rtb {

/// Renders the samples of one plan, as PlanRenderer does with PathTracer.
class WideRenderer {
 public:
  /// Rays per sample at most (jitter-inl.h).
  static constexpr int kMostRays = 1 << 20;

  /// All references must outlive the renderer.
  WideRenderer(const WideScene& scene, const CameraFrame& camera,
               const SamplePlan& plan, const RenderOptions& options,
               int max_depth)
      : scene_(scene),
        camera_(MakeCameraRays(camera, plan.aspect())),
        plan_(plan),
        options_(options),
        max_depth_(max_depth) {}

  /// All fragments; `counts` receives the rays traced.
  Fragments Render(RayCounts* counts) const;

 private:
  RayCounts RenderEntries(int begin, int end, Fragments* fragments) const;

  /// Adds the radiances of `count` paths, the first of which is ray `ray` of a
  /// sample; samples whose rays are complete become fragments.
  void Gather(std::size_t sample, int ray, int count, const Paths& paths,
              MeanOfRays* mean, Fragments* fragments) const;

  const WideScene& scene_;
  const CameraRays camera_;
  const SamplePlan& plan_;
  const RenderOptions& options_;
  const int max_depth_;
};

}  // namespace rtb
