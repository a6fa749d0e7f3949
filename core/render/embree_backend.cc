#include "core/render/embree_backend.h"

#include <optional>
#include <utility>

#include "core/accel/embree_accel.h"
#include "core/base/check.h"
#include "core/render/integrators.h"
#include "core/scene/flat_scene.h"
#include "core/scene/load.h"

namespace rtb {
namespace {

/// A scene at one time, ready to be traced.
struct Prepared {
  double time = 0;
  Geometry geometry;
  ShadingScene shading;
  std::optional<EmbreeAccel> accel;
};

/// One part of the scene, the lights' shapes included.
Result<FlatScene> FlattenPart(const Scene& scene, double time, FlatPart part) {
  RTB_ASSIGN_OR_RETURN(FlatScene flat, Flatten(scene, time, part));
  RTB_RETURN_IF_ERROR(AddLightShapes(scene, time, part, &flat));
  return flat;
}

/// What shadow rays lose at each object's surface.
std::vector<Rgb> Transmittances(const Prepared& prepared) {
  const ShadingView shading = ViewOf(prepared.shading);
  std::vector<Rgb> transmittance;
  transmittance.reserve(prepared.geometry.objects.size());
  for (const ObjectData& object : prepared.geometry.objects) {
    const bool is_light = object.light >= 0;
    transmittance.push_back(
        is_light ? Rgb(0)
                 : ShadowTransmittance(shading.material(object.material)));
  }
  return transmittance;
}

Result<std::unique_ptr<Prepared>> Prepare(const Scene& scene, double time,
                                          int threads) {
  auto prepared = std::make_unique<Prepared>();
  prepared->time = time;
  RTB_ASSIGN_OR_RETURN(const FlatScene still,
                       FlattenPart(scene, time, FlatPart::kStill));
  RTB_ASSIGN_OR_RETURN(const FlatScene moving,
                       FlattenPart(scene, time, FlatPart::kMoving));
  prepared->geometry = MakeGeometry(still, scene.meshes);
  ReplaceMoving(moving, &prepared->geometry);
  RTB_ASSIGN_OR_RETURN(prepared->shading, MakeShadingScene(scene));
  PlaceLights(scene, time, prepared->geometry, &prepared->shading);
  RTB_ASSIGN_OR_RETURN(prepared->accel,
                       EmbreeAccel::Build(prepared->geometry,
                                          Transmittances(*prepared), threads));
  return prepared;
}

/// Takes a prepared scene to another time; only what moves is touched.
Status Move(const Scene& scene, double time, int threads, Prepared* prepared) {
  RTB_ASSIGN_OR_RETURN(const FlatScene moving,
                       FlattenPart(scene, time, FlatPart::kMoving));
  ReplaceMoving(moving, &prepared->geometry);
  PlaceLights(scene, time, prepared->geometry, &prepared->shading);
  RTB_RETURN_IF_ERROR(
      prepared->accel->Update(Transmittances(*prepared), threads));
  prepared->time = time;
  return {};
}

class EmbreeBackend : public Backend {
 public:
  explicit EmbreeBackend(const Scene& scene) : scene_(scene) {}

  std::string name() const override { return "embree"; }
  RayCounts ray_counts() const override { return counts_; }

  Result<Fragments> Render(const SamplePlan& plan,
                           const RenderOptions& options) override {
    RTB_RETURN_IF_ERROR(CheckIntegrator(scene_, options));
    RTB_RETURN_IF_ERROR(GoTo(options.time, options.threads));
    return RenderPlan(*prepared_->accel, ViewOf(prepared_->shading), scene_,
                      plan, options, &counts_);
  }

 private:
  Status GoTo(double time, int threads) {
    if (prepared_ != nullptr && prepared_->time == time) return {};
    if (prepared_ == nullptr) {
      RTB_ASSIGN_OR_RETURN(prepared_, Prepare(scene_, time, threads));
      return {};
    }
    const Status moved = Move(scene_, time, threads, prepared_.get());
    if (!moved) prepared_ = nullptr;  // half moved
    return moved;
  }

  const Scene& scene_;
  std::unique_ptr<Prepared> prepared_;
  RayCounts counts_;
};

}  // namespace

Result<std::unique_ptr<Backend>> MakeEmbreeBackend(const Scene& scene) {
  return std::make_unique<EmbreeBackend>(scene);
}

}  // namespace rtb
