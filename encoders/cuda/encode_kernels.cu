// The kernels: each thread calls the body of encode_kernels.h with its number.
#include "core/cuda/kernel.cuh"
#include "encoders/cuda/encode_kernels.h"
#include "encoders/cuda/encode_launch.h"

namespace rtb {

RTB_KERNEL(rtb_encode_half, EncodeJob, EncodeHalfCell)
RTB_KERNEL(rtb_encode_quadrant, EncodeJob, EncodeQuadrantCell)
RTB_KERNEL(rtb_encode_partition, EncodeJob, EncodePartitionCell)
RTB_KERNEL(rtb_encode_tiv, EncodeJob, EncodeTivCell)

cudaError_t LaunchEncodeHalf(const EncodeJob& job, cudaStream_t stream) {
  return LaunchKernel(rtb_encode_half, job, job.cell_count, stream);
}

cudaError_t LaunchEncodeQuadrant(const EncodeJob& job, cudaStream_t stream) {
  return LaunchKernel(rtb_encode_quadrant, job, job.cell_count, stream);
}

cudaError_t LaunchEncodePartition(const EncodeJob& job, cudaStream_t stream) {
  return LaunchKernel(rtb_encode_partition, job, job.cell_count, stream);
}

cudaError_t LaunchEncodeTiv(const EncodeJob& job, cudaStream_t stream) {
  return LaunchKernel(rtb_encode_tiv, job, job.cell_count, stream);
}

}  // namespace rtb
