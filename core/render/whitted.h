/// @file
/// The Whitted integrator, host and device.
#pragma once

#include <algorithm>
#include <optional>

#include "core/base/host_device.h"
#include "core/render/eye_sample.h"
#include "core/render/lobe_light.h"
#include "core/render/pending_ray.h"
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
/// reflections several rays where the eye ray or its mirror image hits, as in
/// Cook, Porter and Carpenter, "Distributed Ray Tracing", SIGGRAPH 1984. These
/// share the shadow rays of what they hit. The recursion is an explicit stack.
/// @tparam Tracer answers Closest(ray), Occluded(ray), Transmittance(ray) and
///     geometry().
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
    Push({eye.ray, eye.cone.width, Rgb(1), 0, 1, eye.index, 1, 1, 0, false});
    while (size_ > 0) {
      const PendingRay pending = stack_[--size_];
      Count(pending, counts);
      radiance += pending.weight * Shade(eye, pending, counts);
    }
    return radiance;
  }

 private:
  /// Reflection rays of a rough surface that the eye ray meets. A power of 2.
  static constexpr int kGlossyRays = 16;

  RTB_HD static void Count(const PendingRay& pending, RayCounts* counts) {
    if (pending.depth == 0) {
      ++counts->camera;
    } else if (pending.refracted) {
      ++counts->refraction;
    } else {
      ++counts->reflection;
    }
  }

  /// Siblings in a rough lobe weigh as if each were the whole lobe, so that
  /// their number does not matter.
  RTB_HD bool IsDim(const PendingRay& pending, const Rgb& weight) const {
    return MaxComponent(weight) * static_cast<float>(pending.siblings) <=
           least_weight_;
  }

  RTB_HD void Push(const PendingRay& pending) {
    if (pending.depth > max_depth_) return;
    if (IsDim(pending, pending.weight)) return;
    stack_[size_++] = pending;
  }

  RTB_HD void PushMirrored(const PendingRay& from, const Interaction& at,
                           const Rgb& weight) {
    const V3f mirrored = Reflect(from.ray.direction, at.normal);
    Push(ChildOf(from, at, at.AboveSurface(mirrored), weight, 0));
  }

  /// Radiance that the hit surface adds by itself; pushes what it reflects
  /// and transmits.
  RTB_HD Rgb Shade(const EyeSample& eye, const PendingRay& pending,
                   RayCounts* counts) {
    const Ray& ray = pending.ray;
    const Hit hit = tracer_.Closest(ray);
    if (hit.kind == PrimitiveKind::kNothing) {
      return BackgroundRadiance(shading_.background, ray.direction);
    }
    const Interaction at =
        MakeInteraction(shading_, tracer_.geometry(), ray, hit,
                        {pending.width, eye.cone.spread});
    if (at.bsdf.model == SurfaceModel::kEmissive) {
      return at.emitted * EmissionWeight(pending, at, hit.t);
    }
    PushChildren(eye, pending, at);
    return IsLit(at.bsdf) ? LightOf(eye, pending, at, counts) : Rgb(0);
  }

  /// A rough reflection of a light is in the lobe's direct light too.
  RTB_HD float EmissionWeight(const PendingRay& pending, const Interaction& at,
                              float distance) const {
    if (!at.is_light || !(pending.lobe_pdf > 0)) return 1;
    const ObjectData& object = tracer_.geometry().objects[at.point.object];
    const LightData& light = shading_.lights[object.light];
    return LobeRayWeight(light, pending.ray, pending.lobe_pdf, distance,
                         LightPoints(light, pending.siblings / pending.fan));
  }

  /// What the surface reflects and transmits.
  RTB_HD void PushChildren(const EyeSample& eye, const PendingRay& pending,
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
  RTB_HD Rgb LightOf(const EyeSample& eye, const PendingRay& pending,
                     const Interaction& at, RayCounts* counts) const {
    const Rgb direct = DirectLight(eye, pending, at, counts);
    return at.bsdf.model == SurfaceModel::kMetal ? direct
                                                 : direct + Ambient(at);
  }

  RTB_HD Rgb Ambient(const Interaction& at) const {
    return at.bsdf.color * shading_.ambient;
  }

  /// Points of a light with extent for one of so many siblings.
  RTB_HD static int LightPoints(const LightData& light, int siblings) {
    return std::max(1, light.samples / siblings);
  }

  /// Light of all lights that the surface sends to the viewer.
  RTB_HD Rgb DirectLight(const EyeSample& eye, const PendingRay& pending,
                         const Interaction& at, RayCounts* counts) const {
    Rgb radiance(0);
    for (int i = 0; i < shading_.declared_lights; ++i) {
      const LightData& light = shading_.lights[i];
      const auto purpose = static_cast<std::uint32_t>(i + 1);
      std::optional<StratifiedPoints> points;
      int samples = 1;
      float lobe_rays = 0;
      if (HasExtent(light)) {
        samples = LightPoints(light, pending.siblings);
        points.emplace(eye, pending.run, pending.branch, purpose, samples);
        lobe_rays = static_cast<float>(LobeRays(pending, at)) /
                    static_cast<float>(samples);
      }
      Rgb sum(0);
      for (int k = 0; k < samples; ++k) {
        const LightSample sample = SampleLightByArea(
            light, at.point.position, points ? points->At(k) : V2f(0));
        sum += Received(light, sample, at, lobe_rays, counts);
      }
      radiance += sum / static_cast<float>(samples);
    }
    return radiance;
  }

  /// What one sample of a light contributes. Called, so that `at` need not be
  /// in registers meanwhile.
  /// @param lobe_rays for each sample.
  RTB_HD_CALLED Rgb Received(const LightData& light, const LightSample& sample,
                             const Interaction& at, float lobe_rays,
                             RayCounts* counts) const {
    if (sample.irradiance == Rgb(0)) return Rgb(0);
    const Ray ray = ShadowRay(at.point, light, sample);
    // Through glass the lobe's rays do not come straight.
    if (lobe_rays > 0 && shading_.transparent && tracer_.Occluded(ray)) {
      lobe_rays = 0;
    }
    const Rgb response =
        lobe_rays > 0 ? LobeResponse(at, shading_.ggx_energy, sample, lobe_rays)
                      : Response(at, sample.direction);
    if (response == Rgb(0)) return Rgb(0);
    ++counts->shadow;
    return response * sample.irradiance * tracer_.Transmittance(ray);
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

  RTB_HD void PushReflected(const EyeSample& eye, const PendingRay& pending,
                            const Interaction& at) {
    if (at.bsdf.alpha == 0) {
      const float cosine = std::min(1.0f, at.outgoing.dot(at.normal));
      PushMirrored(pending, at, SpecularFresnel(at.bsdf, cosine));
    } else {
      PushGlossy(eye, pending, at);
    }
  }

  /// How many rays stand for the surface's rough lobe: fewer of what a mirror
  /// or glass shows faintly, so that all of an eye ray's stay about as many,
  /// and one of what a rough reflection shows. All of them or none are worth
  /// following: points of lights leave to them what they may bring. Called:
  /// inlined twice, it makes the kernel spill registers.
  RTB_HD_CALLED int LobeRays(const PendingRay& pending,
                             const Interaction& at) const {
    if (!IsGlossy(at.bsdf) || pending.depth == max_depth_) return 0;
    const float cosine = std::min(1.0f, at.outgoing.dot(at.normal));
    if (least_weight_ > 0 &&
        IsDim(pending, pending.weight * SpecularFresnel(at.bsdf, cosine))) {
      return 0;
    }
    if (pending.siblings > 1) return 1;
    int rays = kGlossyRays;
    const float wanted = kGlossyRays * MaxComponent(pending.weight);
    while (rays > 1 && 0.75f * static_cast<float>(rays) > wanted) rays /= 2;
    return rays;
  }

  RTB_HD void PushGlossy(const EyeSample& eye, const PendingRay& pending,
                         const Interaction& at) {
    const int rays = LobeRays(pending, at);
    if (rays == 0) return;
    const StratifiedPoints points(eye, pending.run, pending.branch, 0, rays);
    const V3f wo = at.ToLocal(at.outgoing);
    for (int k = 0; k < rays; ++k) {
      const BsdfSample sample =
          SampleGlossy(at.bsdf, shading_.ggx_energy, wo, points.At(k));
      const V3f direction = at.ToWorld(sample.wi);
      if (!(sample.pdf > 0) || !(direction.dot(at.geometric) > 0)) continue;
      if (sample.weight == Rgb(0)) continue;
      PendingRay next = ChildOf(pending, at, direction,
                                sample.weight / static_cast<float>(rays), 2);
      next.run = pending.run * static_cast<std::uint32_t>(rays) +
                 static_cast<std::uint32_t>(k);
      next.siblings = pending.siblings * rays;
      next.fan = rays;
      next.lobe_pdf = sample.pdf * static_cast<float>(rays);
      stack_[size_++] = next;
    }
  }

  RTB_HD void PushDielectric(const PendingRay& pending, const Interaction& at) {
    const V3f& d = pending.ray.direction;
    const float eta = at.from_outside ? 1 / at.bsdf.ior : at.bsdf.ior;
    const float cosine = std::min(1.0f, -d.dot(at.normal));
    const float f = FresnelDielectric(cosine, eta);
    PushMirrored(pending, at, Rgb(f));
    if (f < 1) {
      PendingRay next = ChildOf(pending, at, Refract(d, at.normal, eta),
                                at.bsdf.color * (1 - f), 1);
      next.refracted = true;
      Push(next);
    }
  }

  const Tracer& tracer_;
  const ShadingView shading_;
  const int max_depth_;
  const float least_weight_;
  int size_ = 0;
  // A popped ray pushes at most two, one level deeper; once on each way down,
  // those of a rough lobe.
  PendingRay stack_[kMaxDepth + kGlossyRays + 2];
};

}  // namespace rtb
