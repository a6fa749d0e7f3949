/// @file
/// Memory that CUDA lends: arrays on the device, and pinned ones on the host,
/// which the device copies to and from by itself. Freed with their owners.
#pragma once

#include <cuda_runtime_api.h>

#include <cstddef>
#include <span>
#include <utility>

#include "core/base/result.h"
#include "core/cuda/cuda_status.h"

namespace rtb {

/// Bytes on the device.
struct DeviceHeap {
  static Status Allocate(void** memory, std::size_t bytes) {
    return CheckDeviceAllocation(cudaMalloc(memory, bytes), bytes);
  }
  static void Free(void* memory) { (void)cudaFree(memory); }
};

/// Bytes on the host that never move.
struct PinnedHeap {
  static Status Allocate(void** memory, std::size_t bytes) {
    return CheckPinnedAllocation(cudaMallocHost(memory, bytes), bytes);
  }
  static void Free(void* memory) { (void)cudaFreeHost(memory); }
};

/// An array that grows when it has to and then forgets what it held.
template <class T, class Heap>
class CudaArray {
 public:
  CudaArray() = default;
  CudaArray(CudaArray&& other) noexcept
      : data_(std::exchange(other.data_, nullptr)),
        capacity_(std::exchange(other.capacity_, 0)) {}
  CudaArray& operator=(CudaArray&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(capacity_, other.capacity_);
    return *this;
  }
  ~CudaArray() {
    if (data_ != nullptr) Heap::Free(data_);
  }

  T* data() const { return data_; }
  std::size_t capacity() const { return capacity_; }

  /// Makes room for `count`. Waits for the device where it has to grow.
  Status Reserve(std::size_t count) {
    if (count <= capacity_) return {};
    *this = CudaArray();
    void* memory = nullptr;
    RTB_RETURN_IF_ERROR(Heap::Allocate(&memory, count * sizeof(T)));
    data_ = static_cast<T*>(memory);
    capacity_ = count;
    return {};
  }

 private:
  T* data_ = nullptr;
  std::size_t capacity_ = 0;
};

template <class T>
using PinnedArray = CudaArray<T, PinnedHeap>;

/// An array on the device that mirrors one of the host. T is plain data.
template <class T>
class DeviceArray : public CudaArray<T, DeviceHeap> {
 public:
  /// Queues a copy of what the host has, which may not change before
  /// FinishUploads. The first `same` are known to be there already, unless
  /// the array has to grow.
  Status Upload(std::span<const T> host, cudaStream_t stream,
                std::size_t same = 0) {
    if (host.size() > this->capacity()) same = 0;
    RTB_RETURN_IF_ERROR(this->Reserve(host.size()));
    const std::span<const T> fresh = host.subspan(same);
    if (fresh.empty()) return {};
    return CheckCuda(
        cudaMemcpyAsync(this->data() + same, fresh.data(), fresh.size_bytes(),
                        cudaMemcpyHostToDevice, stream),
        "copying to the device");
  }
};

}  // namespace rtb
