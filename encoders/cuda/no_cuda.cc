// Stands in for the encoders on the GPU where CUDA is not compiled in.
#include "encoders/cuda/device_encoder.h"

namespace rtb {

Result<std::unique_ptr<DeviceEncoder>> DeviceEncoder::Make(
    const std::string& /*name*/) {
  return Fail(CudaRuns().error());
}

}  // namespace rtb
