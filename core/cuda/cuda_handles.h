/// @file
/// CUDA's streams and events with owners.
#pragma once

#include <cuda_runtime_api.h>

#include <utility>

#include "core/base/result.h"
#include "core/cuda/cuda_status.h"

namespace rtb {

/// Owns what Destroy takes.
template <class Handle, cudaError_t (*Destroy)(Handle)>
class CudaHandle {
 public:
  CudaHandle() = default;
  explicit CudaHandle(Handle handle) : handle_(handle) {}
  CudaHandle(CudaHandle&& other) noexcept
      : handle_(std::exchange(other.handle_, nullptr)) {}
  CudaHandle& operator=(CudaHandle&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  ~CudaHandle() {
    if (handle_ != nullptr) (void)Destroy(handle_);
  }
  Handle get() const { return handle_; }

 private:
  Handle handle_ = nullptr;
};

using CudaStream = CudaHandle<cudaStream_t, cudaStreamDestroy>;
using CudaEvent = CudaHandle<cudaEvent_t, cudaEventDestroy>;

/// A stream that does not wait for the default one.
inline Result<CudaStream> MakeCudaStream() {
  cudaStream_t stream = nullptr;
  RTB_RETURN_IF_ERROR(
      CheckCuda(cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking),
                "making a stream"));
  return CudaStream(stream);
}

/// An event without a time.
inline Result<CudaEvent> MakeCudaEvent() {
  cudaEvent_t event = nullptr;
  RTB_RETURN_IF_ERROR(
      CheckCuda(cudaEventCreateWithFlags(&event, cudaEventDisableTiming),
                "making an event"));
  return CudaEvent(event);
}

}  // namespace rtb
