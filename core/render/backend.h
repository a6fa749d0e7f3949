/// @file
/// Backend: a scene made ready on a device, answering sample plans. The flow:
/// Scene -> MakeBackend -> Backend::Render(plan) -> Fragments.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "core/base/result.h"
#include "core/render/fragments.h"
#include "core/render/ray_counts.h"
#include "core/render/sample_plan.h"
#include "core/scene/animation.h"
#include "core/scene/scene.h"

namespace rtb {

/// What a rendering depends on beside the scene and the plan.
struct RenderOptions {
  double time = 0;         ///< Seconds along the movement paths.
  int spp = 1;             ///< Rays per sample; 1 = its point, no jitter.
  std::uint64_t seed = 0;  ///< Of the stratified positions (spp > 1).
  int max_depth = -1;      ///< Bounces after the eye ray; -1 = the scene's.
  int threads = 0;         ///< Upper bound; 0 = all cores.
  std::string integrator = "whitted";
  /// Rays of `whitted` that count for no more than this in any channel are not
  /// followed; 0: all are. A bound in the sense of Hall and Greenberg, "A
  /// Testbed for Realistic Image Synthesis", IEEE CG&A 3(8), 1983.
  float least_weight = 0;
  /// `path` follows many paths at once where it can (wide/wide_scene.h says
  /// which scenes); the radiances are the same, and RayCounts tells.
  bool vectors = true;
  /// A camera in place of the scene's at that time.
  std::optional<CameraFrame> camera;
};

/// A scene prepared for rendering on one device.
class Backend {
 public:
  virtual ~Backend() = default;

  /// The name by which the command line knows it.
  virtual std::string name() const = 0;

  /// Renders every sample of the plan: linear radiance, not exposed. The
  /// result depends on the arguments alone, never on the number of threads.
  /// One call at a time. @return also the errors of Flatten.
  virtual Result<Fragments> Render(const SamplePlan& plan,
                                   const RenderOptions& options) = 0;

  /// Rays traced by the last Render.
  virtual RayCounts ray_counts() const = 0;
};

/// One row of the table of backends.
struct BackendInfo {
  const char* name;
  const char* description;
  bool compiled;  ///< Part of this program.
  /// Success when it can run here, else a kMissing Error that says why not.
  /// May take a second where a driver has to be found.
  Status (*check)();
};

/// All backends that the command line names, available or not.
std::span<const BackendInfo> Backends();

/// A backend of that name for `scene`, which must outlive it. The scene is
/// composed and its accelerator built by the first Render at each time.
/// @return kBadInput for an unknown name, kMissing for one that is not
/// available.
Result<std::unique_ptr<Backend>> MakeBackend(const std::string& name,
                                             const Scene& scene);

}  // namespace rtb
