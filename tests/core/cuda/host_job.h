// A kernel's job whose pointers are the host's, and a launcher that runs a
// kernel's body for every thread of every block: what the GPU does, on the CPU.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "core/accel/bvh_accel.h"
#include "core/base/check.h"
#include "core/cuda/kernels.h"
#include "core/render/integrators.h"
#include "core/render/traced_scene.h"
#include "core/scene/load.h"

namespace rtb::testing {

inline constexpr std::size_t kThreadsOfBlock = 64;

/// Calls body(job, index) for each thread of as many blocks as cover `count`;
/// the last block has threads to spare.
template <class Job, class Body>
void LaunchOnHost(const Job& job, std::size_t count, const Body& body) {
  const std::size_t blocks = (count + kThreadsOfBlock - 1) / kThreadsOfBlock;
  for (std::size_t i = 0; i < blocks * kThreadsOfBlock; ++i) body(job, i);
}

/// One of the repository's scenes by its path from the root.
inline Scene SceneAt(const std::string& path) {
  return LoadScene(std::filesystem::path(RTB_TEST_SOURCE_DIR) / path).value();
}

/// What the CUDA backend uploads, left on the host: outputs of exactly the
/// plan's size, so that AddressSanitizer sees every step beyond.
class HostJob {
 public:
  HostJob(const Scene& scene, const SamplePlan& plan,
          const RenderOptions& options)
      : prepared_(scene), samples_(plan.samples()) {
    RTB_CHECK(prepared_.GoTo(options.time, 1).has_value());
    job_.rays.camera = MakeCameraRays(CameraOf(scene, options), plan.aspect());
    job_.rays.plan = ViewOf(plan);
    job_.rays.spp = options.spp;
    job_.rays.seed = options.seed;
    job_.scene = prepared_.accel().view();
    job_.shading = ViewOf(prepared_.shading());
    job_.max_depth = DepthOf(scene, options);
    job_.least_weight = options.least_weight;
    values_.assign(samples_, Rgb(-1));
    variances_.assign(options.spp > 1 ? samples_ : 0, -1.0f);
    counts_.resize(samples_);
    job_.values = values_.data();
    job_.variances = variances_.empty() ? nullptr : variances_.data();
    job_.counts = counts_.data();
  }

  const RenderJob& job() const { return job_; }
  std::size_t samples() const { return samples_; }
  const std::vector<Rgb>& values() const { return values_; }
  const std::vector<float>& variances() const { return variances_; }
  const std::vector<RayCounts>& counts() const { return counts_; }

 private:
  TracedScene<BvhAccel> prepared_;
  std::size_t samples_;
  RenderJob job_;
  std::vector<Rgb> values_;
  std::vector<float> variances_;
  std::vector<RayCounts> counts_;
};

}  // namespace rtb::testing
