/// @file
/// The CUDA backend as the rest of the program sees it: without any of CUDA's
/// headers. core/cuda implements it; built without CUDA it says so
/// (no_cuda.cc).
#pragma once

#include <memory>
#include <string>

#include "core/render/backend.h"

namespace rtb {

/// Whether it is part of this program.
bool CudaIsCompiledIn();

/// Success when it can run here; else a kMissing Error that says why not: not
/// compiled in, no driver, no device, or none that is new enough. Looks for
/// the driver when first called, which may take a second.
Status CudaRuns();

/// What the GPU is called, and its compute capability: `NVIDIA H100 (9.0)`.
/// @return CudaRuns's Error.
Result<std::string> CudaDeviceName();

/// What happens to a frame on the device (core/cuda/device_stage.h).
class DeviceStage;

/// A backend that can render a frame while the one before is still on its
/// way back. Render is Submit, then Collect.
class AheadBackend : public Backend {
 public:
  /// Frames that may be under way.
  static constexpr int kFramesAhead = 2;

  /// Begins a frame; fewer than kFramesAhead are under way.
  /// @param stage takes the frame over on the device, where it is not null.
  virtual Status Submit(const SamplePlan& plan, const RenderOptions& options,
                        DeviceStage* stage) = 0;
  Status Submit(const SamplePlan& plan, const RenderOptions& options) {
    return Submit(plan, options, nullptr);
  }
  /// Waits for the oldest frame under way; there is one. Without values where
  /// a stage took them over.
  virtual Result<Fragments> Collect() = 0;
};

/// Prepares a scene (which must outlive the backend) for a GPU.
/// @return CudaRuns's Error.
Result<std::unique_ptr<AheadBackend>> MakeCudaBackend(const Scene& scene);

}  // namespace rtb
