// Encoder `rounds`: a half block from one sample above, and one below whose
// place depends on what the first shows. No good encoder, but the shortest that
// asks in rounds.
#include "tests/encoders/rounds_encoder.h"

#include <memory>

namespace rtb {
namespace {

class Rounds : public Encoder {
 public:
  Result<Encoding> Run(FragmentSource& source, GridSize grid,
                       double cell_aspect,
                       const EncodeContext& /*context*/) const override {
    SamplePlan plan = RegularPlan(grid, 1, 1, cell_aspect);
    plan.footprint = V2f(0.5f, 0.5f);
    plan.positions = {V2f(0.5f, 0.25f)};
    RTB_ASSIGN_OR_RETURN(Fragments upper, source.Query(plan));
    SamplePlan next = plan;
    next.positions.clear();
    for (int cell = 0; cell < grid.cells(); ++cell) {
      const bool right = upper.cell(cell)[0].y > 0.5f;
      next.cells.push_back(cell);
      next.samples_before.push_back(1);
      next.positions.emplace_back(right ? 0.75f : 0.25f, 0.75f);
    }
    RTB_ASSIGN_OR_RETURN(Fragments lower, source.Query(next));
    Encoding encoding{CellGrid(grid), 2, {}};
    for (std::size_t i = 0; i < encoding.grid.cells.size(); ++i) {
      encoding.grid.cells[i] = {U'▄', Encode8(lower.values[i]),
                                Encode8(upper.values[i])};
    }
    encoding.evidence.rounds = {{plan, upper}, {next, lower}};
    return encoding;
  }
};

Result<std::unique_ptr<Encoder>> Make(const EncoderParameters& /*given*/) {
  return std::make_unique<Rounds>();
}

}  // namespace

EncoderEntry rounds_entry() {
  return {{"rounds", "half blocks from two rounds", 2, "U+2584", {}}, Make};
}

}  // namespace rtb
