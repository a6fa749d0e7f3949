/// @file
/// The Whitted integrator, host and device.
#pragma once

#include <algorithm>
#include <optional>

#include "core/base/host_device.h"
#include "core/render/eye_sample.h"
#include "core/render/ray_counts.h"
#include "core/render/stratified_points.h"
#include "core/shading/interaction.h"
#include "core/shading/phong.h"
#include "core/shading/shading_scene.h"
#include "core/shading/shadow_ray.h"

namespace rtb {

/// Deepest recursion that the format allows (settings: max_depth).
inline constexpr int kMaxDepth = 64;

/// Whitted, "An Improved Illumination Model for Shaded Display", CACM 23(6),
/// 1980: direct light with shadow rays, one reflected and one refracted ray
/// per specular hit. Lights with extent get several shadow rays, and rough
/// reflections several rays at the eye ray's hit, as in Cook, Porter and
/// Carpenter, "Distributed Ray Tracing", SIGGRAPH 1984. The recursion is an
/// explicit stack.
/// @tparam Tracer answers Closest(ray), Transmittance(ray) and geometry().
template <class Tracer>
class Whitted {
 public:
  /// @param max_depth bounces after the eye ray; a ray past it is black.
  /// @param least_weight rays of no more weight are black too.
  RTB_HD Whitted(const Tracer& tracer, const ShadingView& shading,
                 int max_depth, float least_weight = 0)
      : tracer_(tracer),
        shading_(shading),
        max_depth_(max_depth),
        least_weight_(least_weight) {}

  /// Radiance along an eye ray. Counts the rays that it traces.
  RTB_HD Rgb Radiance(const EyeSample& eye, RayCounts* counts) {
    Rgb radiance(0);
    Push({eye.ray, Rgb(1), 0, 1, false, false});
    while (size_ > 0) {
      const Pending pending = stack_[--size_];
      Count(pending, counts);
      radiance += pending.weight * Shade(eye, pending, counts);
    }
    return radiance;
  }

 private:
  /// Reflection rays of a rough surface that the eye ray meets.
  static constexpr int kGlossyRays = 8;

  /// A ray whose radiance is still to be added, times its weight.
  struct Pending {
    Ray ray;
    Rgb weight;
    int depth;
    std::uint32_t branch;  ///< Which of the eye ray's descendants it is.
    bool rough;  ///< Stands for a lobe that the lights were evaluated for.
    bool refracted;
  };

  RTB_HD static void Count(const Pending& pending, RayCounts* counts) {
    if (pending.depth == 0) {
      ++counts->camera;
    } else if (pending.refracted) {
      ++counts->refraction;
    } else {
      ++counts->reflection;
    }
  }

  RTB_HD void Push(const Pending& pending) {
    if (pending.depth > max_depth_) return;
    if (MaxComponent(pending.weight) <= least_weight_) return;
    stack_[size_++] = pending;
  }

  RTB_HD void PushBounce(const Pending& from, const Interaction& at,
                         const V3f& direction, const Rgb& weight,
                         std::uint32_t child, bool rough = false,
                         bool refracted = false) {
    // Up to 16 children each; the hash of a long line of them may wrap.
    Pending next{{},
                 from.weight * weight,
                 from.depth + 1,
                 from.branch * 16 + child,
                 rough,
                 refracted};
    next.ray.origin = LeavingOrigin(at.point, direction);
    next.ray.direction = direction;
    Push(next);
  }

  RTB_HD void PushMirrored(const Pending& from, const Interaction& at,
                           const Rgb& weight) {
    const V3f mirrored = Reflect(from.ray.direction, at.normal);
    PushBounce(from, at, at.AboveSurface(mirrored), weight, 0);
  }

  /// Radiance that the hit surface adds by itself; pushes what it reflects
  /// and transmits.
  RTB_HD Rgb Shade(const EyeSample& eye, const Pending& pending,
                   RayCounts* counts) {
    const Ray& ray = pending.ray;
    const Hit hit = tracer_.Closest(ray);
    if (hit.kind == PrimitiveKind::kNothing) {
      return BackgroundRadiance(shading_.background, ray.direction);
    }
    const Interaction at =
        MakeInteraction(shading_, tracer_.geometry(), ray, hit);
    if (at.bsdf.model == SurfaceModel::kEmissive) {
      // A rough reflection of a light is in its direct light already.
      return pending.rough && at.is_light ? Rgb(0) : at.emitted;
    }
    PushChildren(eye, pending, at);
    return IsLit(at.bsdf) ? LightOf(eye, pending, at, counts) : Rgb(0);
  }

  /// What the surface reflects and transmits.
  RTB_HD void PushChildren(const EyeSample& eye, const Pending& pending,
                           const Interaction& at) {
    switch (at.bsdf.model) {
      case SurfaceModel::kMirror:
        return PushMirrored(pending, at, at.bsdf.color);
      case SurfaceModel::kPhong:
        return PushMirrored(pending, at, at.reflectance);
      case SurfaceModel::kMetal:
      case SurfaceModel::kPlastic:
        return PushReflected(eye, pending, at);
      case SurfaceModel::kDielectric:
        return PushDielectric(pending, at);
      case SurfaceModel::kLambertian:
      case SurfaceModel::kEmissive:
        return;
    }
  }

  /// Whether lights are worth asking.
  RTB_HD static bool IsLit(const BsdfData& bsdf) {
    return HasNonDelta(bsdf) || bsdf.model == SurfaceModel::kPhong;
  }

  /// Direct light, and for what is not metal the ambient light.
  RTB_HD Rgb LightOf(const EyeSample& eye, const Pending& pending,
                     const Interaction& at, RayCounts* counts) const {
    const Rgb direct = DirectLight(eye, pending, at, counts);
    return at.bsdf.model == SurfaceModel::kMetal ? direct
                                                 : direct + Ambient(at);
  }

  RTB_HD Rgb Ambient(const Interaction& at) const {
    return at.bsdf.color * shading_.ambient;
  }

  /// Light of all lights that the surface sends to the viewer.
  RTB_HD Rgb DirectLight(const EyeSample& eye, const Pending& pending,
                         const Interaction& at, RayCounts* counts) const {
    Rgb radiance(0);
    for (int i = 0; i < shading_.declared_lights; ++i) {
      const LightData& light = shading_.lights[i];
      const auto purpose = static_cast<std::uint32_t>(i + 1);
      std::optional<StratifiedPoints> points;
      if (HasExtent(light)) {
        points.emplace(eye, pending.branch, purpose, light.samples);
      }
      const int samples = points ? light.samples : 1;
      Rgb sum(0);
      for (int k = 0; k < samples; ++k) {
        const LightSample sample = SampleLightByArea(
            light, at.point.position, points ? points->At(k) : V2f(0));
        sum += Received(light, sample, at, counts);
      }
      radiance += sum / static_cast<float>(samples);
    }
    return radiance;
  }

  /// What one sample of a light contributes. Called, so that `at` need not be
  /// in registers meanwhile.
  RTB_HD_CALLED Rgb Received(const LightData& light, const LightSample& sample,
                             const Interaction& at, RayCounts* counts) const {
    if (sample.irradiance == Rgb(0)) return Rgb(0);
    const Rgb response = Response(at, sample.direction);
    if (response == Rgb(0)) return Rgb(0);
    ++counts->shadow;
    return response * sample.irradiance *
           tracer_.Transmittance(ShadowRay(at.point, light, sample));
  }

  /// f |cos|, and Phong's highlight, which takes no cosine.
  RTB_HD Rgb Response(const Interaction& at, const V3f& towards) const {
    if (at.bsdf.model != SurfaceModel::kPhong) {
      return at.Evaluate(shading_.ggx_energy, towards);
    }
    const V3f wo = at.ToLocal(at.outgoing), wi = at.ToLocal(towards);
    if (!(towards.dot(at.geometric) > 0)) return Rgb(0);
    return EvalDiffuse(at.bsdf, wo, wi) * wi.z + EvalPhong(at.bsdf, wo, wi);
  }

  RTB_HD void PushReflected(const EyeSample& eye, const Pending& pending,
                            const Interaction& at) {
    if (at.bsdf.alpha == 0) {
      const float cosine = std::min(1.0f, at.outgoing.dot(at.normal));
      PushMirrored(pending, at, SpecularFresnel(at.bsdf, cosine));
    } else {
      PushGlossy(eye, pending, at);
    }
  }

  RTB_HD void PushGlossy(const EyeSample& eye, const Pending& pending,
                         const Interaction& at) {
    const int rays = pending.depth == 0 ? kGlossyRays : 1;
    const StratifiedPoints points(eye, pending.branch, 0, rays);
    const V3f wo = at.ToLocal(at.outgoing);
    for (int k = 0; k < rays; ++k) {
      const BsdfSample sample =
          SampleGlossy(at.bsdf, shading_.ggx_energy, wo, points.At(k));
      const V3f direction = at.ToWorld(sample.wi);
      if (!(sample.pdf > 0) || !(direction.dot(at.geometric) > 0)) continue;
      PushBounce(pending, at, direction,
                 sample.weight / static_cast<float>(rays),
                 static_cast<std::uint32_t>(2 + k), true);
    }
  }

  RTB_HD void PushDielectric(const Pending& pending, const Interaction& at) {
    const V3f& d = pending.ray.direction;
    const float eta = at.from_outside ? 1 / at.bsdf.ior : at.bsdf.ior;
    const float cosine = std::min(1.0f, -d.dot(at.normal));
    const float f = FresnelDielectric(cosine, eta);
    PushMirrored(pending, at, Rgb(f));
    if (f < 1) {
      PushBounce(pending, at, Refract(d, at.normal, eta),
                 at.bsdf.color * (1 - f), 1, false, true);
    }
  }

  const Tracer& tracer_;
  const ShadingView shading_;
  const int max_depth_;
  const float least_weight_;
  int size_ = 0;
  // A popped ray pushes at most two, one level deeper; the eye ray more.
  Pending stack_[kMaxDepth + kGlossyRays + 2];
};

}  // namespace rtb
