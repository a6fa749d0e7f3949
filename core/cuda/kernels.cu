// The kernels: each thread calls the body of kernels.h with its number.
#include "core/cuda/kernel.cuh"
#include "core/cuda/kernels.h"
#include "core/cuda/launch.h"

namespace rtb {

RTB_KERNEL(rtb_render_whitted, RenderJob, RenderWhitted)
RTB_KERNEL(rtb_render_path, RenderJob, RenderPath)
RTB_KERNEL(rtb_sum_counts, SumJob, SumCounts)

cudaError_t LaunchWhitted(const RenderJob& job, cudaStream_t stream) {
  return LaunchKernel(rtb_render_whitted, job, job.rays.plan.samples(), stream);
}

cudaError_t LaunchPath(const RenderJob& job, cudaStream_t stream) {
  return LaunchKernel(rtb_render_path, job, job.rays.plan.samples(), stream);
}

cudaError_t LaunchSumCounts(const SumJob& job, cudaStream_t stream) {
  return LaunchKernel(rtb_sum_counts, job, job.sum_count, stream);
}

}  // namespace rtb
