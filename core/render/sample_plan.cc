#include "core/render/sample_plan.h"

#include "core/base/check.h"

namespace rtb {

SamplePlan RegularPlan(GridSize grid, int nx, int ny, double cell_aspect) {
  RTB_CHECK_GT(nx, 0);
  RTB_CHECK_GT(ny, 0);
  SamplePlan plan;
  plan.grid = grid;
  plan.cell_aspect = cell_aspect;
  plan.samples_per_cell = nx * ny;
  plan.footprint =
      V2f(1.0f / static_cast<float>(nx), 1.0f / static_cast<float>(ny));
  for (int y = 0; y < ny; ++y) {
    for (int x = 0; x < nx; ++x) {
      plan.positions.emplace_back(
          (static_cast<float>(x) + 0.5f) / static_cast<float>(nx),
          (static_cast<float>(y) + 0.5f) / static_cast<float>(ny));
    }
  }
  return plan;
}

SamplePlan PixelPlan(int width, int height) {
  SamplePlan plan = RegularPlan({width, height}, 1, 1, 1.0);
  plan.beam = V2f(1, 1);
  return plan;
}

}  // namespace rtb
