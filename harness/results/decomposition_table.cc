#include "harness/results/decomposition_table.h"

#include "harness/results/table.h"

namespace rtb {
namespace {

/// A part of a whole in percent.
std::string Percent(double part, double whole) {
  return whole > 0 ? FormatFixed(100 * part / whole, 1) : "-";
}

std::vector<std::string> Row(const RunResult& run) {
  const MseTerms& mse = run.decomposition->mse;
  const double mixed =
      mse.render_sampling + mse.render_encoding + mse.sampling_encoding;
  std::vector<std::string> row = {
      run.encoder,
      FormatFixed(mse.total, 6),
      Percent(mse.render, mse.total),
      Percent(mse.sampling, mse.total),
      Percent(mse.encoding, mse.total),
      Percent(mixed, mse.total),
      mse.font ? Percent(*mse.font, mse.total) : "-"};
  const std::optional<InnerTerms>& inner = run.decomposition->inner;
  for (double InnerTerms::*part :
       {&InnerTerms::capacity, &InnerTerms::masks, &InnerTerms::colors}) {
    row.push_back(inner ? Percent((*inner).*part, mse.encoding) : "-");
  }
  const std::optional<double> oracle = run.decomposition->flip.oracle;
  row.push_back(oracle ? FormatFixed(*oracle, 4) : "-");
  row.push_back(run.bound && run.bound->gap ? FormatFixed(*run.bound->gap, 3)
                                            : "-");
  return row;
}

}  // namespace

std::string FormatDecompositionTable(std::span<const RunResult* const> runs) {
  Table table{{{"encoder", false},
               {"MSE"},
               {"render %"},
               {"sampling %"},
               {"encoding %"},
               {"mixed %"},
               {"font %"},
               {"of encoding: glyphs %"},
               {"masks %"},
               {"colors %"},
               {"oracle FLIP"},
               {"MSE/bound"}},
              {}};
  for (const RunResult* run : runs) {
    if (run->decomposition) table.rows.push_back(Row(*run));
  }
  return table.rows.empty() ? "" : FormatTable(table);
}

}  // namespace rtb
