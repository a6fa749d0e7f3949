// The speed of the flat BVH against Embree's single-ray queries, on the same
// rays, one thread.
#include <benchmark/benchmark.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/accel/bvh_accel.h"
#include "core/accel/embree_accel.h"
#include "core/accel/surface.h"
#include "core/base/parallel.h"
#include "core/math/frame.h"
#include "core/math/random.h"
#include "core/render/camera_rays.h"
#include "core/render/traced_scene.h"
#include "core/scene/animation.h"
#include "core/scene/load.h"
#include "core/shading/bsdf.h"
#include "tests/bench/bench.h"

namespace rtb {
namespace {

constexpr int kWidth = 480;
constexpr int kHeight = 320;

/// A scene under both accelerators.
struct Both {
  Scene scene;
  SceneParts parts;
  std::optional<EmbreeAccel> embree;
  std::optional<BvhAccel> bvh;
  std::vector<Ray> camera;     ///< Through each pixel, row by row.
  std::vector<Ray> scattered;  ///< Leave what those meet, by the cosine.
};

/// A direction about a normal, of density cos / pi.
V3f CosineDirection(const V3f& normal, std::uint32_t i) {
  const V2f u(UnitFloat(RandomBits(i, 0, 0, 1)),
              UnitFloat(RandomBits(i, 0, 1, 1)));
  const Tangents<float> frame = TangentsOf(normal);
  const V3f local = SampleCosine(u);
  return (frame.s * local.x + frame.t * local.y + normal * local.z)
      .normalized();
}

void MakeRays(Both* both) {
  const CameraRays camera =
      MakeCameraRays(CameraAt(both->scene, 0), double{kWidth} / kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const Ray ray = EyeRay(camera, (x + 0.5) / kWidth, (y + 0.5) / kHeight);
      both->camera.push_back(ray);
      const Hit hit = both->embree->Closest(ray);
      if (hit.kind == PrimitiveKind::kNothing) continue;
      const SurfacePoint point = SurfaceAt(both->embree->geometry(), ray, hit);
      const bool inside = point.normal.dot(ray.direction) > 0;
      const V3f normal = inside ? -point.normal : point.normal;
      Ray next;
      next.direction = CosineDirection(
          normal, static_cast<std::uint32_t>(both->camera.size()));
      next.origin = LeavingOrigin(point, next.direction);
      both->scattered.push_back(next);
    }
  }
}

Result<std::unique_ptr<Both>> Load(const std::string& name) {
  const auto folder = std::filesystem::path(RTB_TEST_SOURCE_DIR) / "scenes";
  auto both = std::make_unique<Both>();
  RTB_ASSIGN_OR_RETURN(both->scene, LoadScene(folder / (name + ".yaml")));
  RTB_ASSIGN_OR_RETURN(both->parts, PrepareParts(both->scene, 0));
  const std::vector<Rgb> through = Transmittances(both->parts);
  RTB_ASSIGN_OR_RETURN(EmbreeAccel embree,
                       EmbreeAccel::Build(both->parts.geometry, through));
  RTB_ASSIGN_OR_RETURN(BvhAccel bvh,
                       BvhAccel::Build(both->parts.geometry, through));
  both->embree.emplace(std::move(embree));
  both->bvh.emplace(std::move(bvh));
  MakeRays(both.get());
  return both;
}

/// The scenes' rays are made once for all benchmarks.
const Both* Explore(benchmark::State& state) {
  static const auto both = Load("explore");
  if (both) return both->get();
  state.SkipWithError(both.error().what.c_str());
  return nullptr;
}

/// Seconds that an accelerator takes for all rays.
template <class Accel>
double Seconds(const Accel& accel, const std::vector<Ray>& rays, bool shadow) {
  const auto start = std::chrono::steady_clock::now();
  // In one block: the renderer's floating-point mode, on this thread.
  ParallelFor(1, 1, 1, [&](int, int) {
    for (const Ray& ray : rays) {
      if (shadow) {
        benchmark::DoNotOptimize(accel.Occluded(ray));
      } else {
        benchmark::DoNotOptimize(accel.Closest(ray));
      }
    }
  });
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start)
      .count();
}

/// Both in turn, so that whatever else runs slows both.
void Compare(benchmark::State& state, std::vector<Ray> Both::*which,
             bool shadow) {
  const Both* both = Explore(state);
  if (both == nullptr) return;
  const std::vector<Ray>& rays = both->*which;
  double embree = 0, bvh = 0;
  for ([[maybe_unused]] auto _ : state) {
    embree += Seconds(*both->embree, rays, shadow);
    const double seconds = Seconds(*both->bvh, rays, shadow);
    state.SetIterationTime(seconds);
    bvh += seconds;
  }
  const double million = 1e-6 * static_cast<double>(rays.size()) *
                         static_cast<double>(state.iterations());
  state.counters["bvh_Mrays_per_s"] = million / bvh;
  state.counters["embree_Mrays_per_s"] = million / embree;
  state.counters["ratio"] = embree / bvh;
}

void Register(const std::string& name, std::vector<Ray> Both::*which,
              bool shadow) {
  benchmark::RegisterBenchmark(("bvh/explore/" + name).c_str(),
                               [which, shadow](benchmark::State& state) {
                                 Compare(state, which, shadow);
                               })
      ->UseManualTime()
      ->Unit(benchmark::kMillisecond);
}

}  // namespace

void RegisterBvhBenchmarks() {
  Register("closest/camera", &Both::camera, false);
  Register("closest/scattered", &Both::scattered, false);
  Register("shadow/camera", &Both::camera, true);
  Register("shadow/scattered", &Both::scattered, true);
}

}  // namespace rtb
