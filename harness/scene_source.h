/// @file
/// SceneSource: a FragmentSource that renders a scene, exposure applied.
#pragma once

#include "core/render/backend.h"
#include "core/render/fragment_source.h"

namespace rtb {

/// Answers plans by rendering. Keeps references: the backend must outlive it.
class SceneSource : public FragmentSource {
 public:
  /// @param exposure in stops: radiance is multiplied by 2^exposure.
  SceneSource(Backend& backend, RenderOptions options, double exposure);

  /// Linear radiance of every sample of the plan.
  /// @return kBadInput for a plan of more than kMaxSamples samples, and the
  /// backend's errors.
  Result<Fragments> Query(const SamplePlan& plan) override;

  /// Rays of all queries so far.
  const RayCounts& rays() const { return rays_; }

 private:
  Backend& backend_;
  RenderOptions options_;
  double exposure_;
  RayCounts rays_;
};

}  // namespace rtb
