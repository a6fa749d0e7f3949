/// @file
/// The path integrator, host and device.
#pragma once

#include <algorithm>

#include "core/accel/surface.h"
#include "core/base/host_device.h"
#include "core/math/sobol.h"
#include "core/render/eye_sample.h"
#include "core/render/power_heuristic.h"
#include "core/render/ray_counts.h"
#include "core/shading/emitters.h"
#include "core/shading/interaction.h"
#include "core/shading/shading_scene.h"

namespace rtb {

/// Unbiased path tracing but for the depth limit: Kajiya, "The Rendering
/// Equation", SIGGRAPH 1986, with next-event estimation and the power
/// heuristic of Veach, "Robust Monte Carlo Methods for Light Transport
/// Simulation", 1997, chapter 9.
/// @tparam Tracer answers Closest(ray), Occluded(ray) and geometry().
template <class Tracer>
class PathTracer {
 public:
  /// @param max_depth bounces after the eye ray; a ray past it is black.
  RTB_HD PathTracer(const Tracer& tracer, const ShadingView& shading,
                    int max_depth)
      : tracer_(tracer), shading_(shading), max_depth_(max_depth) {}

  /// One sample of the radiance along an eye ray. Counts the rays it traces.
  RTB_HD Rgb Radiance(const EyeSample& eye, RayCounts* counts) const {
    Path path{eye.ray, eye.cone, Rgb(1), Rgb(0), 0, true, false};
    ++counts->camera;
    for (int depth = 0; Extend(eye, depth, &path, counts); ++depth) {
      CountBounce(path, counts);
    }
    return path.radiance;
  }

 private:
  struct Path {
    Ray ray;  ///< The next one to trace.
    RayCone cone;
    Rgb throughput;
    Rgb radiance;   ///< Gathered so far.
    float pdf;      ///< Of the ray's direction, per solid angle.
    bool specular;  ///< No light can be sampled in its stead.
    bool crossed;   ///< Goes on behind the surface that it left.
  };

  /// Sets of dimensions of one bounce.
  enum DimensionSet : std::uint32_t { kScatter, kLight, kSetsPerBounce };

  RTB_HD static void CountBounce(const Path& path, RayCounts* counts) {
    if (path.crossed) {
      ++counts->refraction;
    } else if (path.specular) {
      ++counts->reflection;
    } else {
      ++counts->scattered;
    }
  }

  RTB_HD static V4f Uniforms(const EyeSample& eye, int depth,
                             DimensionSet set) {
    const std::uint32_t number =
        static_cast<std::uint32_t>(depth) * kSetsPerBounce + set;
    return SobolOwen4(eye.index, SobolSeed(eye.pattern, number, eye.seed));
  }

  /// Traces the path's ray, adds what its end sends back, and scatters there.
  /// @return whether there is another ray to trace.
  RTB_HD bool Extend(const EyeSample& eye, int depth, Path* path,
                     RayCounts* counts) const {
    const Ray& ray = path->ray;
    const Hit hit = tracer_.Closest(ray);
    if (hit.kind == PrimitiveKind::kNothing) {
      AddBackground(path);
      return false;
    }
    const Interaction at =
        MakeInteraction(shading_, tracer_.geometry(), ray, hit, path->cone);
    AddEmission(at, hit, path);
    if (at.bsdf.model == SurfaceModel::kEmissive) return false;
    const bool last = depth == max_depth_;
    if (HasNonDelta(at.bsdf)) {
      AddDirectLight(at, Uniforms(eye, depth, kLight), last, path, counts);
    }
    const V4f u = Uniforms(eye, depth, kScatter);
    if (last) {
      AddUnsampled(at, V3f(u.x, u.y, u.z), path, counts);
      return false;
    }
    return Scatter(at, V3f(u.x, u.y, u.z), path) && Survives(depth, u.w, path);
  }

  RTB_HD void AddBackground(Path* path) const {
    const V3f& direction = path->ray.direction;
    float weight = 1;
    if (!path->specular) {
      weight = PowerHeuristic(path->pdf, EscapePdf(shading_, direction));
    }
    path->radiance += path->throughput *
                      BackgroundRadiance(shading_.background, direction) *
                      weight;
  }

  RTB_HD void AddEmission(const Interaction& at, const Hit& hit,
                          Path* path) const {
    if (at.emitted == Rgb(0)) return;
    float weight = 1;
    if (!path->specular) {
      weight = PowerHeuristic(path->pdf, SampledPdf(at, hit, *path));
    }
    path->radiance += path->throughput * at.emitted * weight;
  }

  /// Next-event estimation at a surface that scatters. `last`: no scattered
  /// ray competes.
  RTB_HD void AddDirectLight(const Interaction& at, const V4f& u, bool last,
                             Path* path, RayCounts* counts) const {
    const EmitterSample light =
        SampleEmitter(shading_, at.point, V3f(u.x, u.y, u.z));
    if (light.irradiance == Rgb(0)) return;
    const Scattered f =
        at.EvaluateWithPdf(shading_.ggx_energy, light.direction);
    if (f.value == Rgb(0)) return;
    float weight = 1;
    if (light.pdf > 0 && !last) weight = PowerHeuristic(light.pdf, f.pdf);
    ++counts->shadow;
    if (tracer_.Occluded(light.shadow)) return;
    path->radiance += path->throughput * f.value * light.irradiance * weight;
  }

  /// Direct light of emitters that only a scattered ray can find, so that
  /// the depth limit treats all emitters alike.
  RTB_HD void AddUnsampled(const Interaction& at, const V3f& u, Path* path,
                           RayCounts* counts) const {
    if (!shading_.unsampled_emitters || !HasNonDelta(at.bsdf)) return;
    if (!Scatter(at, u, path) || path->specular) return;
    ++counts->shadow;
    const Hit hit = tracer_.Closest(path->ray);
    if (hit.kind == PrimitiveKind::kNothing) return;
    const Interaction lamp =
        MakeInteraction(shading_, tracer_.geometry(), path->ray, hit);
    if (lamp.emitted == Rgb(0) || SampledPdf(lamp, hit, *path) > 0) return;
    path->radiance += path->throughput * lamp.emitted;
  }

  /// The density with which next-event estimation would have chosen the end of
  /// the path's ray.
  RTB_HD float SampledPdf(const Interaction& at, const Hit& hit,
                          const Path& path) const {
    return EmitterPdf(shading_, tracer_.geometry(), path.ray, hit, at);
  }

  /// Chooses the next direction by the BSDF.
  RTB_HD bool Scatter(const Interaction& at, const V3f& u, Path* path) const {
    const Bounce bounce = at.Sample(shading_.ggx_energy, u);
    path->throughput *= bounce.weight;
    path->pdf = bounce.pdf;
    path->specular = bounce.delta;
    path->crossed = bounce.direction.dot(at.geometric) < 0;
    path->ray = Ray{};
    path->ray.origin = LeavingOrigin(at.point, bounce.direction);
    path->ray.direction = bounce.direction;
    path->cone = at.cone;
    return path->throughput != Rgb(0);
  }

  /// Russian roulette by throughput: Arvo and Kirk, "Particle Transport and
  /// Image Synthesis", SIGGRAPH 1990.
  RTB_HD static bool Survives(int depth, float u, Path* path) {
    constexpr int kCertainBounces = 3;
    if (depth < kCertainBounces) return true;
    const Rgb& t = path->throughput;
    const float survival = std::min(0.95f, std::max(t.x, std::max(t.y, t.z)));
    if (!(u < survival)) return false;
    path->throughput /= survival;
    return true;
  }

  const Tracer& tracer_;
  const ShadingView shading_;
  const int max_depth_;
};

}  // namespace rtb
