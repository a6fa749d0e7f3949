#include "core/render/plan_view.h"

namespace rtb {

PlanView ViewOf(const SamplePlan& plan) {
  const auto pointer = [](const std::vector<int>& list) {
    return list.empty() ? nullptr : list.data();
  };
  PlanView view;
  view.columns = plan.grid.columns;
  view.rows = plan.grid.rows;
  view.entries = plan.entries();
  view.samples_per_cell = plan.samples_per_cell;
  view.stride = plan.uniform() ? 0 : plan.samples_per_cell;
  view.positions = plan.positions.data();
  view.footprint = plan.footprint;
  view.beam = plan.beam;
  view.cells = pointer(plan.cells);
  view.samples_before = pointer(plan.samples_before);
  return view;
}

}  // namespace rtb
