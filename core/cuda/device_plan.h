/// @file
/// DevicePlan: a SamplePlan mirrored on the device.
#pragma once

#include <cuda_runtime_api.h>

#include <optional>

#include "core/base/result.h"
#include "core/cuda/device_array.h"
#include "core/render/plan_view.h"

namespace rtb {

/// The lists of the plan of the last frame; a frame that asks for the same
/// again, as frames do, uploads nothing.
class DevicePlan {
 public:
  Status Upload(const SamplePlan& plan, cudaStream_t stream);

  /// The view in the device's pointers; valid until the next Upload.
  const PlanView& view() const { return view_; }

 private:
  bool Has(const SamplePlan& plan) const;

  std::optional<SamplePlan> plan_;  ///< Whose lists are there.
  DeviceArray<V2f> positions_;
  DeviceArray<int> cells_;
  DeviceArray<int> samples_before_;
  PlanView view_;
};

}  // namespace rtb
