/// @file
/// Evidence: the samples that a grid was chosen from, for whoever judges or
/// changes the choice afterwards (modifiers/).
#pragma once

#include <span>
#include <vector>

#include "core/render/fragments.h"
#include "core/render/sample_plan.h"

namespace rtb {

/// A query and its answer.
struct SampleRound {
  SamplePlan plan;
  Fragments fragments;
};

/// All that an encoder saw.
struct Evidence {
  std::vector<SampleRound> rounds;
  /// Samples really traced for each of these values: 1, or less where an
  /// encoder interpolated the values from fewer samples.
  double weight = 1;
  /// Standard deviation of the noise of these values over that of a sample: 1,
  /// or less where an encoder averaged samples.
  double noise = 1;
};

/// One sample of a cell.
struct CellSample {
  V2f position;   ///< Inside the cell.
  V2f footprint;  ///< In cells.
  Rgb linear;
  float variance = 0;  ///< As Fragments::variances; 0 where unknown.
};

/// Evidence sorted by cell.
class SamplesByCell {
 public:
  explicit SamplesByCell(const Evidence& evidence);

  /// The samples of one cell, in the order they were asked for.
  std::span<const CellSample> cell(int index) const {
    const auto at = static_cast<std::size_t>(index);
    return std::span(samples_).subspan(begin_[at], begin_[at + 1] - begin_[at]);
  }

 private:
  std::vector<std::size_t> begin_;  ///< One more than there are cells.
  std::vector<CellSample> samples_;
};

}  // namespace rtb
