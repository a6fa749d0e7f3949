#include "encoders/plan_encoder.h"

#include <utility>

namespace rtb {

Result<Encoding> PlanEncoder::Run(FragmentSource& source, GridSize grid,
                                  double cell_aspect,
                                  const EncodeContext& context) const {
  const SamplePlan plan = Plan(grid, cell_aspect, context.seed);
  RTB_ASSIGN_OR_RETURN(const Fragments fragments, source.Query(plan));
  RTB_ASSIGN_OR_RETURN(CellGrid cells, Encode(fragments, context));
  return Encoding{std::move(cells), static_cast<double>(plan.samples_per_cell)};
}

}  // namespace rtb
