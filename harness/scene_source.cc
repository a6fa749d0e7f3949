#include "harness/scene_source.h"

#include <cmath>
#include <utility>

#include "harness/arguments.h"

namespace rtb {

SceneSource::SceneSource(Backend& backend, RenderOptions options,
                         double exposure)
    : backend_(backend), options_(std::move(options)), exposure_(exposure) {}

Result<Fragments> SceneSource::Query(const SamplePlan& plan) {
  RTB_RETURN_IF_ERROR(CheckSampleCount("--grid", plan));
  RTB_ASSIGN_OR_RETURN(Fragments fragments, backend_.Render(plan, options_));
  rays_ += backend_.ray_counts();
  if (exposure_ != 0) {
    const float gain = static_cast<float>(std::exp2(exposure_));
    for (Rgb& value : fragments.values) value *= gain;
    for (float& variance : fragments.variances) variance *= gain * gain;
  }
  return fragments;
}

}  // namespace rtb
