#include "core/cuda/cuda_frame.h"

#include <algorithm>
#include <span>

#include "core/cuda/launch.h"

namespace rtb {
namespace {

template <class T>
Status CopyBack(const DeviceArray<T>& device, const PinnedArray<T>& host,
                std::size_t count, cudaStream_t stream) {
  return CheckCuda(
      cudaMemcpyAsync(host.data(), device.data(), count * sizeof(T),
                      cudaMemcpyDeviceToHost, stream),
      "copying from the device");
}

}  // namespace

Result<CudaFrame> CudaFrame::Make() {
  CudaFrame frame;
  RTB_ASSIGN_OR_RETURN(frame.rendered_, MakeCudaEvent());
  RTB_ASSIGN_OR_RETURN(frame.copied_, MakeCudaEvent());
  RTB_RETURN_IF_ERROR(frame.partial_sums_.Reserve(kPartialSums));
  RTB_RETURN_IF_ERROR(frame.sums_.Reserve(kSums));
  RTB_RETURN_IF_ERROR(frame.host_sums_.Reserve(kSums));
  return frame;
}

Status CudaFrame::Prepare(const SamplePlan& plan, RenderJob* job) {
  plan_ = plan;
  has_variances_ = job->rays.spp > 1;
  const std::size_t samples = plan.samples();
  // The device's memory is the scarcer.
  RTB_RETURN_IF_ERROR(values_.Reserve(samples));
  RTB_RETURN_IF_ERROR(counts_.Reserve(samples));
  if (has_variances_) RTB_RETURN_IF_ERROR(variances_.Reserve(samples));
  RTB_RETURN_IF_ERROR(host_values_.Reserve(samples));
  if (has_variances_) RTB_RETURN_IF_ERROR(host_variances_.Reserve(samples));
  job->values = values_.data();
  job->variances = has_variances_ ? variances_.data() : nullptr;
  job->counts = counts_.data();
  return {};
}

Status CudaFrame::SumCounts(cudaStream_t compute) {
  const SumJob first{counts_.data(), plan_.samples(), partial_sums_.data(),
                     kPartialSums};
  RTB_RETURN_IF_ERROR(
      CheckCuda(LaunchSumCounts(first, compute), "summing ray counts"));
  const SumJob second{partial_sums_.data(), kPartialSums, sums_.data(), kSums};
  return CheckCuda(LaunchSumCounts(second, compute), "summing ray counts");
}

Status CudaFrame::CopyValues(cudaStream_t copy) {
  const std::size_t samples = plan_.samples();
  RTB_RETURN_IF_ERROR(CopyBack(values_, host_values_, samples, copy));
  if (!has_variances_) return {};
  return CopyBack(variances_, host_variances_, samples, copy);
}

Status CudaFrame::Copy(cudaStream_t compute, cudaStream_t copy,
                       DeviceStage* stage) {
  has_values_ = stage == nullptr;
  RTB_RETURN_IF_ERROR(SumCounts(compute));
  RTB_RETURN_IF_ERROR(
      CheckCuda(cudaEventRecord(rendered_.get(), compute), "cudaEventRecord"));
  RTB_RETURN_IF_ERROR(CheckCuda(cudaStreamWaitEvent(copy, rendered_.get(), 0),
                                "cudaStreamWaitEvent"));
  RTB_RETURN_IF_ERROR(has_values_
                          ? CopyValues(copy)
                          : stage->Queue({values_.data(), compute, copy}));
  RTB_RETURN_IF_ERROR(CopyBack(sums_, host_sums_, kSums, copy));
  return CheckCuda(cudaEventRecord(copied_.get(), copy), "cudaEventRecord");
}

Result<Fragments> CudaFrame::Collect(RayCounts* counts) {
  RTB_RETURN_IF_ERROR(
      CheckCuda(cudaEventSynchronize(copied_.get()), "rendering"));
  Fragments fragments;
  fragments.grid = plan_.grid;
  fragments.samples_per_cell = plan_.samples_per_cell;
  const std::size_t samples = plan_.samples();
  if (has_values_) {
    fragments.values.assign(host_values_.data(), host_values_.data() + samples);
  }
  if (has_values_ && has_variances_) {
    fragments.variances.assign(host_variances_.data(),
                               host_variances_.data() + samples);
  }
  *counts = RayCounts{};
  for (const RayCounts& sum : std::span(host_sums_.data(), kSums)) {
    *counts += sum;
  }
  return fragments;
}

}  // namespace rtb
