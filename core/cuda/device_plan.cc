#include "core/cuda/device_plan.h"

#include <span>

namespace rtb {

bool DevicePlan::Has(const SamplePlan& plan) const {
  return plan_ && plan_->positions == plan.positions &&
         plan_->cells == plan.cells &&
         plan_->samples_before == plan.samples_before;
}

Status DevicePlan::Upload(const SamplePlan& plan, cudaStream_t stream) {
  if (!Has(plan)) {
    plan_.reset();  // half uploaded
    RTB_RETURN_IF_ERROR(positions_.Upload(std::span(plan.positions), stream));
    RTB_RETURN_IF_ERROR(cells_.Upload(std::span(plan.cells), stream));
    RTB_RETURN_IF_ERROR(
        samples_before_.Upload(std::span(plan.samples_before), stream));
    RTB_RETURN_IF_ERROR(FinishUploads(stream));
    plan_ = plan;
  }
  view_ = ViewOf(plan);
  view_.positions = positions_.data();
  if (view_.cells != nullptr) view_.cells = cells_.data();
  if (view_.samples_before != nullptr) {
    view_.samples_before = samples_before_.data();
  }
  return {};
}

}  // namespace rtb
