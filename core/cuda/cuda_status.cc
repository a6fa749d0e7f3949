#include "core/cuda/cuda_status.h"

#include <string>

namespace rtb {
namespace {

constexpr char kPlace[] = "--backend=cuda";
constexpr char kWithout[] = "--backend=bvh does the same without a GPU";

bool MeansMissing(cudaError_t code) {
  return code == cudaErrorInsufficientDriver || code == cudaErrorNoDevice ||
         code == cudaErrorStubLibrary ||
         code == cudaErrorCompatNotSupportedOnDevice ||
         code == cudaErrorNoKernelImageForDevice ||
         code == cudaErrorUnsupportedPtxVersion ||
         code == cudaErrorDevicesUnavailable ||
         code == cudaErrorSystemDriverMismatch;
}

std::string MebibytesOf(std::size_t bytes) {
  return std::to_string((bytes + (1 << 20) - 1) >> 20) + " MiB";
}

}  // namespace

Status CheckCuda(cudaError_t code, const char* call) {
  if (code == cudaSuccess) return {};
  // A failed call is told of once; a later one has its own answer.
  (void)cudaGetLastError();
  const std::string what = std::string(call) + ": " + cudaGetErrorString(code);
  if (MeansMissing(code)) return Fail(Missing(kPlace, what, kWithout));
  if (code == cudaErrorMemoryAllocation) {
    return Fail(Failure(kPlace, what,
                        "the device's memory does not suffice: take a smaller "
                        "grid, or --backend=bvh"));
  }
  return Fail(Failure(kPlace, what, kWithout));
}

Status CheckDeviceAllocation(cudaError_t code, std::size_t bytes) {
  if (code != cudaErrorMemoryAllocation) return CheckCuda(code, "cudaMalloc");
  (void)cudaGetLastError();
  std::size_t free = 0;
  std::size_t total = 0;
  RTB_RETURN_IF_ERROR(
      CheckCuda(cudaMemGetInfo(&free, &total), "cudaMemGetInfo"));
  return Fail(Failure(kPlace,
                      "the device's memory does not suffice: found " +
                          MebibytesOf(free) + " free of " + MebibytesOf(total) +
                          ", expected " + MebibytesOf(bytes) + " more",
                      "take a smaller grid or scene, or --backend=bvh"));
}

Status CheckPinnedAllocation(cudaError_t code, std::size_t bytes) {
  if (code != cudaErrorMemoryAllocation) {
    return CheckCuda(code, "cudaMallocHost");
  }
  (void)cudaGetLastError();
  return Fail(Failure(kPlace,
                      "the host's memory does not suffice: expected " +
                          MebibytesOf(bytes) + " more that stay in place",
                      "take a smaller grid, or --backend=bvh"));
}

Status FinishUploads(cudaStream_t stream) {
  return CheckCuda(cudaStreamSynchronize(stream), "copying to the device");
}

}  // namespace rtb
