#include "tests/encoders/picture_source.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace rtb {

Result<Fragments> PictureSource::Query(const SamplePlan& plan) {
  plans_.push_back(plan);
  Fragments fragments(plan);
  for (int entry = 0; entry < plan.entries(); ++entry) {
    const int cell = plan.cell(entry);
    const auto samples = fragments.cell(entry);
    for (int i = 0; i < plan.samples_per_cell; ++i) {
      const V2f& at = plan.position(entry, i);
      const double x = cell % plan.grid.columns + double{at.x};
      const double y = cell / plan.grid.columns + double{at.y};
      Rgb& color = samples[static_cast<std::size_t>(i)];
      color = Rgb(picture_(x, y, 0), picture_(x, y, 1), picture_(x, y, 2));
    }
  }
  return fragments;
}

double PictureSource::samples() const {
  double sum = 0;
  for (const SamplePlan& plan : plans_) {
    sum += static_cast<double>(plan.samples());
  }
  return sum;
}

void ExpectSound(const SamplePlan& plan, GridSize grid, double cell_aspect) {
  EXPECT_EQ(plan.grid, grid);
  EXPECT_EQ(plan.cell_aspect, cell_aspect);
  EXPECT_GT(plan.samples_per_cell, 0);
  const auto samples = static_cast<std::size_t>(plan.samples_per_cell);
  EXPECT_TRUE(plan.positions.size() == samples ||
              plan.positions.size() == plan.samples())
      << plan.positions.size();
  EXPECT_TRUE(std::ranges::all_of(
      plan.cells, [&](int cell) { return cell >= 0 && cell < grid.cells(); }));
  EXPECT_TRUE(plan.samples_before.empty() ||
              plan.samples_before.size() == plan.cells.size());
  EXPECT_TRUE(std::ranges::all_of(plan.positions, [](const V2f& position) {
    return std::min(position.x, position.y) >= 0 &&
           std::max(position.x, position.y) < 1;
  }));
  EXPECT_GT(std::min(plan.footprint.x, plan.footprint.y), 0.0f);
  EXPECT_LE(std::max(plan.footprint.x, plan.footprint.y), 1.0f);
}

}  // namespace rtb
