#include "core/render/embree_backend.h"

#include <optional>
#include <utility>

#include "core/accel/embree_accel.h"
#include "core/base/check.h"
#include "core/render/plan_renderer.h"
#include "core/scene/flat_scene.h"
#include "core/scene/load.h"

namespace rtb {
namespace {

/// A scene at one time, ready to be traced.
struct Prepared {
  double time;
  Geometry geometry;
  ShadingScene shading;
  std::optional<EmbreeAccel> accel;
};

Result<std::unique_ptr<Prepared>> Prepare(const Scene& scene, double time,
                                          int threads) {
  RTB_ASSIGN_OR_RETURN(const FlatScene flat, Flatten(scene, time));
  auto prepared = std::make_unique<Prepared>();
  prepared->time = time;
  prepared->geometry = MakeGeometry(flat);
  prepared->shading = MakeShadingScene(scene, time);
  const ShadingView shading = ViewOf(prepared->shading);
  std::vector<Rgb> transmittance;
  for (const ObjectData& object : prepared->geometry.objects) {
    transmittance.push_back(
        ShadowTransmittance(shading.material(object.material)));
  }
  RTB_ASSIGN_OR_RETURN(prepared->accel,
                       EmbreeAccel::Build(prepared->geometry,
                                          std::move(transmittance), threads));
  return prepared;
}

class EmbreeBackend : public Backend {
 public:
  explicit EmbreeBackend(const Scene& scene) : scene_(scene) {}

  std::string name() const override { return "embree"; }
  RayCounts ray_counts() const override { return counts_; }

  Result<Fragments> Render(const SamplePlan& plan,
                           const RenderOptions& options) override {
    if (options.integrator != "whitted") {
      return Fail(BadInput("--integrator",
                           "unknown integrator `" + options.integrator + "`",
                           "whitted"));
    }
    if (prepared_ == nullptr || prepared_->time != options.time) {
      RTB_ASSIGN_OR_RETURN(prepared_,
                           Prepare(scene_, options.time, options.threads));
    }
    const int max_depth =
        options.max_depth >= 0 ? options.max_depth : scene_.settings.max_depth;
    RTB_CHECK_LE(max_depth, kMaxDepth);
    const CameraFrame camera =
        options.camera ? *options.camera : CameraAt(scene_, options.time);
    const PlanRenderer renderer(*prepared_->accel, ViewOf(prepared_->shading),
                                camera, plan, options, max_depth);
    return renderer.Render(&counts_);
  }

 private:
  const Scene& scene_;
  std::unique_ptr<Prepared> prepared_;
  RayCounts counts_;
};

}  // namespace

Result<std::unique_ptr<Backend>> MakeEmbreeBackend(const Scene& scene) {
  RTB_RETURN_IF_ERROR(CheckRenderable(scene));
  return std::make_unique<EmbreeBackend>(scene);
}

}  // namespace rtb
