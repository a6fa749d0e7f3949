/// @file
/// The launches of the kernels of encode_kernels.cu, one thread a cell.
#pragma once

#include <cuda_runtime_api.h>

#include "encoders/cuda/encode_kernels.h"

namespace rtb {

/// Queues one of the bodies of encode_kernels.h for every cell of the job.
cudaError_t LaunchEncodeHalf(const EncodeJob& job, cudaStream_t stream);
cudaError_t LaunchEncodeQuadrant(const EncodeJob& job, cudaStream_t stream);
cudaError_t LaunchEncodePartition(const EncodeJob& job, cudaStream_t stream);
cudaError_t LaunchEncodeTiv(const EncodeJob& job, cudaStream_t stream);

}  // namespace rtb
