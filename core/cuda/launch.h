/// @file
/// The launches of the kernels of kernels.cu, one thread a sample.
#pragma once

#include <cuda_runtime_api.h>

#include <cstddef>

#include "core/cuda/kernels.h"

namespace rtb {

/// Queues RenderWhitted or RenderPath for every sample of the job.
cudaError_t LaunchWhitted(const RenderJob& job, cudaStream_t stream);
cudaError_t LaunchPath(const RenderJob& job, cudaStream_t stream);

/// Queues SumCounts for every sum of the job.
cudaError_t LaunchSumCounts(const SumJob& job, cudaStream_t stream);

}  // namespace rtb
