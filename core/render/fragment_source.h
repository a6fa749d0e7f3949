/// @file
/// FragmentSource: whatever can answer a SamplePlan - a renderer looking at a
/// scene, or an image file. An adaptive encoder may query it several times.
#pragma once

#include "core/base/result.h"
#include "core/render/fragments.h"
#include "core/render/sample_plan.h"

namespace rtb {

/// Answers sample plans with linear radiance, exposure applied.
class FragmentSource {
 public:
  virtual ~FragmentSource() = default;

  /// One fragment for each sample of the plan.
  virtual Result<Fragments> Query(const SamplePlan& plan) = 0;
};

}  // namespace rtb
