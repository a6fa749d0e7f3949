/// @file
/// DeviceStage: what is to happen to a frame on the device, in place of its
/// way back to the host.
#pragma once

#include <cuda_runtime_api.h>

#include "core/base/result.h"
#include "core/math/vec.h"

namespace rtb {

/// Samples of a frame on the device. Valid for what is queued on `compute`
/// before the next frame's kernels.
struct DeviceSamples {
  const Rgb* values = nullptr;  ///< In the plan's order: linear radiance.
  cudaStream_t compute = nullptr;
  cudaStream_t copy = nullptr;  ///< Of what goes back to the host.
};

/// Queues its own kernels and copies. The frame counts as collected when all
/// that it put on `copy` is done.
class DeviceStage {
 public:
  virtual ~DeviceStage() = default;
  virtual Status Queue(const DeviceSamples& samples) = 0;
};

}  // namespace rtb
