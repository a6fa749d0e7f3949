/// @file
/// PictureSource: a picture for tests of encoders that is known everywhere.
#pragma once

#include <functional>
#include <vector>

#include "core/render/fragment_source.h"

namespace rtb {

/// The linear value of one channel (0..2) at (x, y): in cells, from the
/// picture's top left.
using Picture = std::function<float(double x, double y, int channel)>;

/// Answers each sample with the picture's value at its position, and keeps the
/// plans.
class PictureSource : public FragmentSource {
 public:
  explicit PictureSource(Picture picture) : picture_(std::move(picture)) {}

  Result<Fragments> Query(const SamplePlan& plan) override;

  const std::vector<SamplePlan>& plans() const { return plans_; }
  /// In all plans together.
  double samples() const;

 private:
  Picture picture_;
  std::vector<SamplePlan> plans_;
};

/// Expects a plan to be of that grid, and to say for each cell where in the
/// cell its samples are.
void ExpectSound(const SamplePlan& plan, GridSize grid, double cell_aspect);

}  // namespace rtb
