/// @file
/// PlanView: a SamplePlan as bare pointers, for host and device code.
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/base/host_device.h"
#include "core/render/sample_plan.h"

namespace rtb {

/// What is asked for, as SamplePlan has it. Null lists are empty ones.
struct PlanView {
  int columns = 0;
  int rows = 0;
  int entries = 0;
  int samples_per_cell = 0;
  /// From one entry's first position to the next one's; 0 = one pattern.
  int stride = 0;
  const V2f* positions = nullptr;
  V2f footprint{1, 1};
  V2f beam{1, 1};
  const int* cells = nullptr;
  const int* samples_before = nullptr;

  /// Samples in all.
  RTB_HD std::size_t samples() const {
    return static_cast<std::size_t>(entries) *
           static_cast<std::size_t>(samples_per_cell);
  }
  /// The cell of an entry.
  RTB_HD int cell(int entry) const {
    return cells == nullptr ? entry : cells[entry];
  }
  /// The number of an entry's sample among all of its cell.
  RTB_HD int number(int entry, int sample) const {
    return sample + (samples_before == nullptr ? 0 : samples_before[entry]);
  }
  /// Position of one sample of one entry.
  RTB_HD const V2f& position(int entry, int sample) const {
    return positions[static_cast<std::size_t>(entry) *
                         static_cast<std::size_t>(stride) +
                     static_cast<std::size_t>(sample)];
  }
};

/// A view of a plan, which must outlive it.
PlanView ViewOf(const SamplePlan& plan);

}  // namespace rtb
