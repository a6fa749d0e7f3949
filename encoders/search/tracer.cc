#include "encoders/search/tracer.h"

#include <utility>

namespace rtb {

SearchTracer::SearchTracer(FragmentSource& source, const SearchPattern& pattern)
    : source_(source),
      pattern_(pattern),
      cells_(static_cast<std::size_t>(pattern.grid.cells()),
             {SearchRays(pattern.strips), {}}) {}

Status SearchTracer::TraceEverywhere(std::span<const int> strips) {
  std::vector<StripRequest> requests;
  for (int cell = 0; cell < pattern_.grid.cells(); ++cell) {
    for (const auto direction : kDirections) {
      for (const int strip : strips) {
        requests.push_back({cell, direction, strip});
      }
    }
  }
  return Trace(requests);
}

Status SearchTracer::Trace(const std::vector<StripRequest>& requests) {
  SampleRound round{PlanOf(requests), {}};
  RTB_ASSIGN_OR_RETURN(round.fragments, source_.Query(round.plan));
  std::vector<V3d> colors(requests.size(), V3d(0));
  ToBlend(pattern_.blend, round.fragments.values, colors);
  for (std::size_t i = 0; i < requests.size(); ++i) {
    const StripRequest& request = requests[i];
    SearchedCell& cell = cells_[static_cast<std::size_t>(request.cell)];
    cell.rays.of(request.direction).Set(request.strip, colors[i]);
    cell.placed.push_back({round.plan.positions[i], colors[i]});
  }
  evidence_.rounds.push_back(std::move(round));
  return {};
}

double SearchTracer::rays_per_cell() const {
  std::size_t rays = 0;
  for (const SearchedCell& cell : cells_) rays += cell.placed.size();
  return static_cast<double>(rays) / pattern_.grid.cells();
}

SamplePlan SearchTracer::PlanOf(
    const std::vector<StripRequest>& requests) const {
  SamplePlan plan;
  plan.grid = pattern_.grid;
  plan.cell_aspect = pattern_.cell_aspect;
  plan.samples_per_cell = 1;
  plan.footprint = V2f(0.125f, 0.125f);
  for (const StripRequest& request : requests) {
    const bool again = !plan.cells.empty() && plan.cells.back() == request.cell;
    const auto before = static_cast<int>(
        cells_[static_cast<std::size_t>(request.cell)].placed.size());
    plan.samples_before.push_back(again ? plan.samples_before.back() + 1
                                        : before);
    plan.cells.push_back(request.cell);
    plan.positions.push_back(StripPosition(request.direction, pattern_.strips,
                                           request.cell, request.strip,
                                           pattern_.seed));
  }
  return plan;
}

}  // namespace rtb
