#include "harness/live/region_source.h"

#include "core/base/check.h"

namespace rtb {

Result<Fragments> RegionSource::Query(const SamplePlan& plan) {
  RTB_CHECK(plan.grid == region_.size());
  if (region_.whole()) return picture_.Query(plan);
  SamplePlan mapped = plan;
  mapped.grid = region_.grid;
  mapped.cells.resize(static_cast<std::size_t>(plan.entries()));
  for (int entry = 0; entry < plan.entries(); ++entry) {
    mapped.cells[static_cast<std::size_t>(entry)] =
        region_.CellOf(plan.cell(entry));
  }
  RTB_ASSIGN_OR_RETURN(Fragments fragments, picture_.Query(mapped));
  fragments.grid = plan.grid;
  return fragments;
}

}  // namespace rtb
