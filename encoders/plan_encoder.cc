#include "encoders/plan_encoder.h"

#include <utility>

namespace rtb {

Result<Encoding> PlanEncoder::Run(FragmentSource& source, GridSize grid,
                                  double cell_aspect,
                                  const EncodeContext& context) const {
  SampleRound round;
  round.plan = Plan(grid, cell_aspect, context.seed);
  RTB_ASSIGN_OR_RETURN(round.fragments, source.Query(round.plan));
  Encoding encoding;
  RTB_ASSIGN_OR_RETURN(encoding.grid, Encode(round.fragments, context));
  encoding.rays_per_cell = round.plan.samples_per_cell;
  encoding.evidence.rounds.push_back(std::move(round));
  return encoding;
}

}  // namespace rtb
