#include "encoders/encoder.h"

namespace rtb {

Result<Encoding> Encoder::Run(FragmentSource& source, GridSize grid,
                              double cell_aspect,
                              const EncodeContext& context) const {
  const SamplePlan plan = Plan(grid, cell_aspect, context.seed);
  RTB_ASSIGN_OR_RETURN(const Fragments fragments, source.Query(plan));
  return Encoding{Encode(fragments, context),
                  static_cast<double>(plan.samples_per_cell)};
}

}  // namespace rtb
