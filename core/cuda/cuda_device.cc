#include "core/cuda/cuda_device.h"

#include <cuda_runtime_api.h>

#include <string>

#include "core/cuda/cuda_status.h"

namespace rtb {
namespace {

/// The oldest that the kernels are compiled for: Turing.
constexpr int kLeastCapability = 75;

constexpr char kPlace[] = "--backend=cuda";
constexpr char kWithout[] = "--backend=bvh does the same without a GPU";

/// CUDA's version as it counts them: 13000 is 13.0.
std::string VersionText(int version) {
  return std::to_string(version / 1000) + "." +
         std::to_string(version % 1000 / 10);
}

Result<int> Attribute(cudaDeviceAttr attribute) {
  int value = 0;
  RTB_RETURN_IF_ERROR(CheckCuda(cudaDeviceGetAttribute(&value, attribute, 0),
                                "cudaDeviceGetAttribute"));
  return value;
}

}  // namespace

Status UseCudaDevice() {
  int driver = 0;  // stays 0 where there is none
  RTB_RETURN_IF_ERROR(
      CheckCuda(cudaDriverGetVersion(&driver), "looking for a driver"));
  if (driver == 0) {
    return Fail(Missing(kPlace, "there is no NVIDIA driver", kWithout));
  }
  int count = 0;
  const cudaError_t counted = cudaGetDeviceCount(&count);
  if (counted == cudaErrorInsufficientDriver) {
    (void)cudaGetLastError();
    return Fail(Missing(kPlace,
                        "found a driver for CUDA " + VersionText(driver) +
                            ", expected one for " + VersionText(CUDART_VERSION),
                        "renew the driver; --backend=bvh needs none"));
  }
  RTB_RETURN_IF_ERROR(CheckCuda(counted, "looking for a GPU"));
  if (count == 0) return CheckCuda(cudaErrorNoDevice, "looking for a GPU");
  RTB_ASSIGN_OR_RETURN(const int major,
                       Attribute(cudaDevAttrComputeCapabilityMajor));
  RTB_ASSIGN_OR_RETURN(const int minor,
                       Attribute(cudaDevAttrComputeCapabilityMinor));
  if (10 * major + minor < kLeastCapability) {
    return Fail(Missing(
        kPlace,
        "found a GPU of compute capability " + std::to_string(major) + "." +
            std::to_string(minor) + ", expected 7.5 or newer",
        count > 1 ? "CUDA_VISIBLE_DEVICES=1 takes another GPU" : kWithout));
  }
  return CheckCuda(cudaSetDevice(0), "choosing the GPU");
}

}  // namespace rtb
