/// @file
/// What CUDA's runtime answers, as the program's Errors.
#pragma once

#include <cuda_runtime_api.h>

#include <cstddef>

#include "core/base/result.h"

namespace rtb {

/// Success, or an Error that names the call. A missing driver or device is
/// kMissing, all else kFailure.
/// @param call what was asked of CUDA, in words or by its function's name.
Status CheckCuda(cudaError_t code, const char* call);

/// The same for an allocation on the device: says how much was asked for and
/// how much is free.
Status CheckDeviceAllocation(cudaError_t code, std::size_t bytes);

/// The same for the host's pinned memory: says how much was asked for.
Status CheckPinnedAllocation(cudaError_t code, std::size_t bytes);

/// Waits until the device has all that was to be copied to it: from ordinary
/// memory it may read as late as the stream comes to it.
Status FinishUploads(cudaStream_t stream);

}  // namespace rtb
