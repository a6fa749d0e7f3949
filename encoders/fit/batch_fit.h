/// @file
/// BatchFit: FitCell for many cells at once, in sRGB, from linear samples.
#pragma once

#include <optional>
#include <span>

#include "core/math/vec.h"
#include "encoders/cell.h"
#include "encoders/fit/atlas.h"
#include "encoders/fit/survey_plan.h"

namespace rtb {

/// Gives the cells of FitCell with Blend::kSrgb, bit for bit: vectors bound
/// every candidate's error (survey.h), and what the bounds leave open is
/// finished as FitCell does. Immutable; safe to share between threads.
class BatchFit {
 public:
  /// @param atlas must outlive the BatchFit.
  explicit BatchFit(const Atlas& atlas);

  /// @param linear linear samples, unclipped, one cell's after the other's.
  void Fit(std::span<const Rgb> linear, std::span<Cell> cells) const;

 private:
  const Atlas& atlas_;
  std::optional<SurveyPlan> plan_;  ///< None for masks that are too large.
};

}  // namespace rtb
