/// @file
/// HostBackend: a backend that traces on the CPU, over any accelerator.
#pragma once

#include <string>
#include <utility>

#include "core/render/backend.h"
#include "core/render/integrators.h"
#include "core/render/traced_scene.h"

namespace rtb {

/// @tparam Accel is what TracedScene takes, and a tracer for RenderPlan.
template <class Accel>
class HostBackend : public Backend {
 public:
  /// @param scene must outlive the backend.
  HostBackend(std::string name, const Scene& scene)
      : name_(std::move(name)), scene_(scene), prepared_(scene) {}

  std::string name() const override { return name_; }
  RayCounts ray_counts() const override { return counts_; }

  Result<Fragments> Render(const SamplePlan& plan,
                           const RenderOptions& options) override {
    RTB_RETURN_IF_ERROR(CheckIntegrator(scene_, options));
    RTB_RETURN_IF_ERROR(prepared_.GoTo(options.time, options.threads));
    return RenderPlan(prepared_.accel(), ViewOf(prepared_.shading()), scene_,
                      plan, options, &counts_);
  }

 private:
  const std::string name_;
  const Scene& scene_;
  TracedScene<Accel> prepared_;
  RayCounts counts_;
};

}  // namespace rtb
