/// @file
/// What every .cu file makes its kernels and launches with.
#pragma once

#include <cuda_runtime_api.h>

#include <cstddef>

namespace rtb {

/// Threads of a block: two warps, so that 32 blocks, the most that a
/// multiprocessor takes, fill it, and a block ends soon after its last thread.
inline constexpr unsigned kBlockThreads = 64;

/// Queues a kernel for `count` threads.
template <class Job>
cudaError_t LaunchKernel(void (*kernel)(Job), const Job& job, std::size_t count,
                         cudaStream_t stream) {
  const auto blocks =
      static_cast<unsigned>((count + kBlockThreads - 1) / kBlockThreads);
  if (blocks == 0) return cudaSuccess;
  kernel<<<blocks, kBlockThreads, 0, stream>>>(job);
  return cudaGetLastError();
}

}  // namespace rtb

/// The kernel `name`: thread k calls Body(job, k). One block a multiprocessor
/// at least: with any more the compiler would spill registers to keep to them.
#define RTB_KERNEL(name, Job, Body)                                \
  extern "C" __global__ void __launch_bounds__(kBlockThreads, 1)   \
      name(const __grid_constant__ Job job) {                      \
    Body(job, std::size_t{blockIdx.x} * blockDim.x + threadIdx.x); \
  }
