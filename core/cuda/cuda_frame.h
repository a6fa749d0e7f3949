/// @file
/// CudaFrame: what one frame leaves on the device, and its way to the host.
#pragma once

#include <cuda_runtime_api.h>

#include <array>
#include <cstddef>

#include "core/base/result.h"
#include "core/cuda/cuda_handles.h"
#include "core/cuda/device_array.h"
#include "core/cuda/device_stage.h"
#include "core/cuda/kernels.h"
#include "core/render/fragments.h"

namespace rtb {

/// The outputs of one rendering. Two of them take turns, so that one is copied
/// while the next is rendered.
class CudaFrame {
 public:
  static Result<CudaFrame> Make();

  /// Makes room for a plan's samples and has the job write there.
  Status Prepare(const SamplePlan& plan, RenderJob* job);
  /// After the job's kernel, on the same stream: sums the ray counts, then
  /// copies everything on the other stream.
  /// @param stage has the values instead, where it is not null.
  Status Copy(cudaStream_t compute, cudaStream_t copy, DeviceStage* stage);
  /// Waits for the copies.
  Result<Fragments> Collect(RayCounts* counts);

 private:
  CudaFrame() = default;

  /// Ray counts are summed on the device to so many, the host does the rest.
  static constexpr std::size_t kSums = 256;
  /// A first pass sums to so many: enough threads to fill a device.
  static constexpr std::size_t kPartialSums = 16384;

  Status SumCounts(cudaStream_t compute);
  Status CopyValues(cudaStream_t copy);

  SamplePlan plan_;
  bool has_values_ = false;     ///< They come back to the host.
  bool has_variances_ = false;  ///< These too.
  DeviceArray<Rgb> values_;
  DeviceArray<float> variances_;
  DeviceArray<RayCounts> counts_, partial_sums_, sums_;
  PinnedArray<Rgb> host_values_;
  PinnedArray<float> host_variances_;
  PinnedArray<RayCounts> host_sums_;
  CudaEvent rendered_, copied_;
};

}  // namespace rtb
