#include "core/render/embree_backend.h"

#include <atomic>
#include <cmath>
#include <limits>
#include <optional>

#include "core/accel/embree_accel.h"
#include "core/base/check.h"
#include "core/base/parallel.h"
#include "core/math/random.h"
#include "core/math/sampling.h"
#include "core/render/camera_rays.h"
#include "core/render/whitted.h"
#include "core/scene/flat_scene.h"
#include "core/scene/load.h"

namespace rtb {
namespace {

/// Cells that one task renders; results do not depend on it.
constexpr int kCellsPerTask = 64;

/// No NaN or infinity leaves the renderer.
float Finite(double value) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  if (std::isnan(value)) return 0;
  return static_cast<float>(std::fmin(value, kLargest));
}

/// A scene at one time, ready to be traced.
struct Prepared {
  double time;
  Geometry geometry;
  ShadingScene shading;
  std::optional<EmbreeAccel> accel;
};

Result<std::unique_ptr<Prepared>> Prepare(const Scene& scene, double time) {
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
  RTB_ASSIGN_OR_RETURN(
      prepared->accel,
      EmbreeAccel::Build(prepared->geometry, std::move(transmittance)));
  return prepared;
}

/// Renders the samples of one plan.
class PlanRenderer {
 public:
  PlanRenderer(const Prepared& prepared, const CameraFrame& camera,
               const SamplePlan& plan, const RenderOptions& options)
      : prepared_(prepared),
        camera_(MakeCameraRays(camera, plan.aspect())),
        plan_(plan),
        options_(options) {}

  /// The cells [begin, end) of the plan.
  RayCounts RenderCells(int begin, int end, int max_depth,
                        Fragments* fragments) const {
    RayCounts counts;
    Integrator whitted(*prepared_.accel, ViewOf(prepared_.shading), max_depth);
    for (int cell = begin; cell < end; ++cell) {
      const std::span<Rgb> out = fragments->cell(cell);
      for (int s = 0; s < plan_.samples_per_cell; ++s) {
        V3d sum(0);
        for (int ray = 0; ray < options_.spp; ++ray) {
          sum += V3d(whitted.Radiance(CameraRay(cell, s, ray), &counts));
        }
        sum /= options_.spp;
        out[static_cast<std::size_t>(s)] =
            Rgb(Finite(sum.x), Finite(sum.y), Finite(sum.z));
      }
    }
    return counts;
  }

 private:
  using Integrator = Whitted<EmbreeAccel>;

  Ray CameraRay(int cell, int sample, int ray) const {
    const V2f jitter = Jitter(cell, sample, ray);
    const V2f& position = plan_.position(cell, sample);
    const GridSize& grid = plan_.grid;
    const double x = cell % grid.columns + double{position.x} + jitter.x;
    const double y = cell / grid.columns + double{position.y} + jitter.y;
    return EyeRay(camera_, x / grid.columns, y / grid.rows);
  }

  /// Offset from the sample's position, in cells: none for one ray, else
  /// stratified over the footprint.
  V2f Jitter(int cell, int sample, int ray) const {
    if (options_.spp == 1) return V2f(0, 0);
    const std::uint32_t pattern =
        RandomBits(static_cast<std::uint32_t>(cell),
                   static_cast<std::uint32_t>(sample), 0, options_.seed);
    const V2f unit =
        MultiJittered(static_cast<std::uint32_t>(ray),
                      static_cast<std::uint32_t>(options_.spp), pattern);
    return (unit - V2f(0.5f, 0.5f)) * plan_.footprint;
  }

  const Prepared& prepared_;
  const CameraRays camera_;
  const SamplePlan& plan_;
  const RenderOptions& options_;
};

class EmbreeBackend : public Backend {
 public:
  explicit EmbreeBackend(const Scene& scene) : scene_(scene) {}

  std::string name() const override { return "embree"; }
  RayCounts ray_counts() const override { return counts_; }

  Status PrepareAt(double time) {
    if (prepared_ != nullptr && prepared_->time == time) return {};
    RTB_ASSIGN_OR_RETURN(prepared_, Prepare(scene_, time));
    return {};
  }

  Result<Fragments> Render(const SamplePlan& plan,
                           const RenderOptions& options) override {
    if (options.integrator != "whitted") {
      return Fail(BadInput("--integrator",
                           "unknown integrator `" + options.integrator + "`",
                           "whitted"));
    }
    RTB_RETURN_IF_ERROR(PrepareAt(options.time));
    const int max_depth =
        options.max_depth >= 0 ? options.max_depth : scene_.settings.max_depth;
    RTB_CHECK_LE(max_depth, kMaxDepth);
    const PlanRenderer renderer(*prepared_, CameraAt(scene_, options.time),
                                plan, options);
    Fragments fragments(plan);
    std::atomic<std::uint64_t> camera{0}, shadow{0}, secondary{0};
    ParallelFor(plan.grid.cells(), kCellsPerTask, options.threads,
                [&](int begin, int end) {
                  const RayCounts counts =
                      renderer.RenderCells(begin, end, max_depth, &fragments);
                  camera += counts.camera;
                  shadow += counts.shadow;
                  secondary += counts.secondary;
                });
    counts_ = {camera, shadow, secondary};
    return fragments;
  }

 private:
  const Scene& scene_;
  std::unique_ptr<Prepared> prepared_;
  RayCounts counts_;
};

}  // namespace

Result<std::unique_ptr<Backend>> MakeEmbreeBackend(const Scene& scene) {
  RTB_RETURN_IF_ERROR(CheckRenderable(scene));
  auto backend = std::make_unique<EmbreeBackend>(scene);
  RTB_RETURN_IF_ERROR(backend->PrepareAt(0));
  return backend;
}

}  // namespace rtb
