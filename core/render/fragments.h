/// @file
/// Fragments: the shaded samples that answer a SamplePlan.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/math/vec.h"
#include "core/render/sample_plan.h"

namespace rtb {

/// entries x samples, linear float RGB, in the plan's order: cell by cell, row
/// by row, for a plan of all cells.
struct Fragments {
  GridSize grid;
  int samples_per_cell = 0;
  std::vector<Rgb> values;
  /// For each value the variance of its estimate, mean over the channels, in
  /// squared linear units; empty where the source cannot tell. Stratification
  /// makes the true one smaller.
  std::vector<float> variances;

  Fragments() = default;
  /// Black fragments for a plan.
  explicit Fragments(const SamplePlan& plan)
      : grid(plan.grid),
        samples_per_cell(plan.samples_per_cell),
        values(plan.samples(), Rgb(0)) {}

  /// The samples of one entry of the plan.
  std::span<Rgb> cell(int index) {
    return std::span(values).subspan(Offset(index), Count());
  }
  /// The samples of one entry of the plan.
  std::span<const Rgb> cell(int index) const {
    return std::span(values).subspan(Offset(index), Count());
  }

 private:
  std::size_t Count() const {
    return static_cast<std::size_t>(samples_per_cell);
  }
  std::size_t Offset(int index) const {
    return static_cast<std::size_t>(index) * Count();
  }
};

}  // namespace rtb
