#include "core/render/cuda_backend.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/accel/bvh_accel.h"
#include "core/base/check.h"
#include "core/cuda/cuda_device.h"
#include "core/cuda/cuda_frame.h"
#include "core/cuda/cuda_handles.h"
#include "core/cuda/device_geometry.h"
#include "core/cuda/device_plan.h"
#include "core/cuda/device_shading.h"
#include "core/cuda/launch.h"
#include "core/render/integrators.h"
#include "core/render/traced_scene.h"

namespace rtb {
namespace {

class CudaBackend : public AheadBackend {
 public:
  static Result<std::unique_ptr<AheadBackend>> Make(const Scene& scene) {
    RTB_RETURN_IF_ERROR(UseCudaDevice());
    std::unique_ptr<CudaBackend> backend(new CudaBackend(scene));
    RTB_ASSIGN_OR_RETURN(backend->compute_, MakeCudaStream());
    RTB_ASSIGN_OR_RETURN(backend->copy_, MakeCudaStream());
    for (std::optional<CudaFrame>& frame : backend->frames_) {
      RTB_ASSIGN_OR_RETURN(frame, CudaFrame::Make());
    }
    return std::unique_ptr<AheadBackend>(std::move(backend));
  }

  /// Nothing of this may be freed while the device works on it.
  ~CudaBackend() override { Drain(); }

  std::string name() const override { return "cuda"; }
  RayCounts ray_counts() const override { return counts_; }

  Result<Fragments> Render(const SamplePlan& plan,
                           const RenderOptions& options) override {
    RTB_CHECK_EQ(submitted_, collected_);
    RTB_RETURN_IF_ERROR(Submit(plan, options));
    return Collect();
  }

  using AheadBackend::Submit;

  Status Submit(const SamplePlan& plan, const RenderOptions& options,
                DeviceStage* stage) override {
    RTB_CHECK_LT(submitted_ - collected_, unsigned{kFramesAhead});
    RTB_RETURN_IF_ERROR(CheckIntegrator(scene_, options));
    const Status queued = Queue(plan, options, stage);
    if (queued) {
      ++submitted_;
    } else {
      Drain();  // The next frame takes the arrays of what was queued of this.
    }
    return queued;
  }

  Result<Fragments> Collect() override {
    RTB_CHECK_LT(collected_, submitted_);
    return frames_[collected_++ % kFramesAhead]->Collect(&counts_);
  }

 private:
  explicit CudaBackend(const Scene& scene) : scene_(scene), prepared_(scene) {}

  /// Waits for all that is under way, whatever came of it.
  void Drain() {
    if (compute_.get() != nullptr) (void)cudaStreamSynchronize(compute_.get());
    if (copy_.get() != nullptr) (void)cudaStreamSynchronize(copy_.get());
  }

  Status Queue(const SamplePlan& plan, const RenderOptions& options,
               DeviceStage* stage) {
    RTB_RETURN_IF_ERROR(GoTo(options.time, options.threads));
    RTB_RETURN_IF_ERROR(plan_.Upload(plan, compute_.get()));
    RenderJob job = JobOf(plan, options);
    CudaFrame& frame = *frames_[submitted_ % kFramesAhead];
    RTB_RETURN_IF_ERROR(frame.Prepare(plan, &job));
    const auto launch =
        options.integrator == "path" ? LaunchPath : LaunchWhitted;
    RTB_RETURN_IF_ERROR(CheckCuda(launch(job, compute_.get()), "rendering"));
    return frame.Copy(compute_.get(), copy_.get(), stage);
  }

  /// Takes the host's scene to a time, and the device's after it. The stream
  /// is in order: a frame under way sees the scene as it was.
  Status GoTo(double time, int threads) {
    if (uploaded_ == time) return {};
    const bool moves = uploaded_.has_value();
    uploaded_.reset();  // Neither there nor here until all of it succeeded.
    RTB_RETURN_IF_ERROR(prepared_.GoTo(time, threads));
    const Geometry& geometry = prepared_.geometry();
    cudaStream_t stream = compute_.get();
    if (moves) {
      RTB_RETURN_IF_ERROR(geometry_.Move(geometry, prepared_.accel(), stream));
      RTB_RETURN_IF_ERROR(shading_.Move(prepared_.shading(), stream));
    } else {
      RTB_RETURN_IF_ERROR(
          geometry_.Upload(geometry, prepared_.accel(), stream));
      RTB_RETURN_IF_ERROR(shading_.Upload(prepared_.shading(), stream));
    }
    RTB_RETURN_IF_ERROR(FinishUploads(stream));
    uploaded_ = time;
    return {};
  }

  RenderJob JobOf(const SamplePlan& plan, const RenderOptions& options) const {
    RenderJob job;
    job.rays.camera = MakeCameraRays(CameraOf(scene_, options), plan.aspect());
    job.rays.plan = plan_.view();
    job.rays.spp = options.spp;
    job.rays.seed = options.seed;
    job.scene = geometry_.view();
    job.shading = shading_.view();
    job.max_depth = DepthOf(scene_, options);
    job.least_weight = options.least_weight;
    return job;
  }

  const Scene& scene_;
  TracedScene<BvhAccel> prepared_;
  std::optional<double> uploaded_;  ///< The time at which the device's is.
  DeviceGeometry geometry_;
  DeviceShading shading_;
  DevicePlan plan_;
  std::array<std::optional<CudaFrame>, kFramesAhead> frames_;
  unsigned submitted_ = 0;
  unsigned collected_ = 0;
  RayCounts counts_;
  CudaStream compute_, copy_;
};

}  // namespace

bool CudaIsCompiledIn() { return true; }

Status CudaRuns() { return UseCudaDevice(); }

Result<std::string> CudaDeviceName() {
  RTB_RETURN_IF_ERROR(UseCudaDevice());
  cudaDeviceProp device{};
  RTB_RETURN_IF_ERROR(CheckCuda(cudaGetDeviceProperties(&device, 0),
                                "cudaGetDeviceProperties"));
  return std::string(device.name) + " (" + std::to_string(device.major) + "." +
         std::to_string(device.minor) + ")";
}

Result<std::unique_ptr<AheadBackend>> MakeCudaBackend(const Scene& scene) {
  return CudaBackend::Make(scene);
}

}  // namespace rtb
