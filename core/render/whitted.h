/// @file
/// The Whitted integrator, host and device.
#pragma once

#include "core/accel/surface.h"
#include "core/base/host_device.h"
#include "core/render/ray_counts.h"
#include "core/shading/fresnel.h"
#include "core/shading/shading_scene.h"

namespace rtb {

/// Deepest recursion that the format allows (settings: max_depth).
inline constexpr int kMaxDepth = 64;

/// Whitted, "An Improved Illumination Model for Shaded Display", CACM 23(6),
/// 1980: direct light with shadow rays, one reflected and one refracted ray
/// per specular hit. The recursion is an explicit stack.
/// @tparam Tracer answers Closest(ray), Transmittance(ray) and geometry().
template <class Tracer>
class Whitted {
 public:
  /// @param max_depth bounces after the eye ray; a ray past it is black.
  RTB_HD Whitted(const Tracer& tracer, const ShadingView& shading,
                 int max_depth)
      : tracer_(tracer), shading_(shading), max_depth_(max_depth) {}

  /// Radiance along an eye ray. Counts the rays that it traces.
  RTB_HD Rgb Radiance(const Ray& eye, RayCounts* counts) {
    Rgb radiance(0);
    Push({eye, Rgb(1), 0});
    ++counts->camera;
    while (size_ > 0) {
      const Pending pending = stack_[--size_];
      if (pending.depth > 0) ++counts->secondary;
      radiance += pending.weight * Shade(pending, counts);
    }
    return radiance;
  }

 private:
  /// A ray whose radiance is still to be added, times its weight.
  struct Pending {
    Ray ray;
    Rgb weight;
    int depth;
  };

  /// A surface hit, as seen from the ray that found it.
  struct View {
    SurfacePoint point;
    V3f normal;         ///< Turned towards the viewer.
    bool from_outside;  ///< The viewer is on the outward side.
  };

  RTB_HD void Push(const Pending& pending) {
    if (pending.depth > max_depth_ || pending.weight == Rgb(0)) return;
    stack_[size_++] = pending;
  }

  RTB_HD void PushBounce(const Pending& from, const View& view,
                         const V3f& direction, const Rgb& weight) {
    Pending next{{}, from.weight * weight, from.depth + 1};
    next.ray.origin = LeavingOrigin(view.point, direction);
    next.ray.direction = direction;
    Push(next);
  }

  /// Radiance that the hit surface adds by itself; pushes what it reflects
  /// and transmits.
  RTB_HD Rgb Shade(const Pending& pending, RayCounts* counts) {
    const Ray& ray = pending.ray;
    const Hit hit = tracer_.Closest(ray);
    if (hit.kind == PrimitiveKind::kNothing) {
      return BackgroundRadiance(shading_.background, ray.direction);
    }
    View view;
    view.point = SurfaceAt(tracer_.geometry(), ray, hit);
    view.from_outside = ray.direction.dot(view.point.normal) < 0;
    view.normal = view.from_outside ? view.point.normal : -view.point.normal;
    const ObjectData& object = tracer_.geometry().objects[view.point.object];
    const MaterialData& material = shading_.material(object.material);
    const Rgb color = ColorAt(material, object, view.point);
    switch (material.model) {
      case SurfaceModel::kLambertian:
        return color * DiffuseLight(view, counts);
      case SurfaceModel::kMirror:
        PushBounce(pending, view, Reflect(ray.direction, view.normal), color);
        return Rgb(0);
      case SurfaceModel::kMetal:
        ShadeMetal(pending, view, color);
        return Rgb(0);
      case SurfaceModel::kDielectric:
        ShadeDielectric(pending, view, material);
        return Rgb(0);
      case SurfaceModel::kEmissive:
        return color;
      case SurfaceModel::kPlastic:  // CheckRenderable refuses these two.
      case SurfaceModel::kPhong:
        return Rgb(0);
    }
    return Rgb(0);
  }

  RTB_HD static Rgb ColorAt(const MaterialData& material,
                            const ObjectData& object,
                            const SurfacePoint& point) {
    if (material.checker.size == 0) return material.color;
    const Affinef& map = object.world_to_object;
    // A world-to-object map takes normals there by its inverse transpose;
    // the cofactors of the linear part give that without inverting.
    const V3f normal = map.y.cross(map.z) * point.normal.x +
                       map.z.cross(map.x) * point.normal.y +
                       map.x.cross(map.y) * point.normal.z;
    return CheckerColor(material.checker, map.Point(point.position),
                        normal.normalized());
  }

  /// Irradiance / pi plus ambient: what a white diffuse surface would emit.
  RTB_HD Rgb DiffuseLight(const View& view, RayCounts* counts) const {
    constexpr float kInversePi = 0.318309886183790672f;
    Rgb irradiance(0);
    for (int i = 0; i < shading_.light_count; ++i) {
      const LightSample light =
          SampleLight(shading_.lights[i], view.point.position);
      const float cosine = light.direction.dot(view.normal);
      if (!(cosine > 0) || light.irradiance == Rgb(0)) continue;
      Ray shadow;
      shadow.origin = LeavingOrigin(view.point, view.normal);
      shadow.direction = light.direction;
      shadow.t_max = light.distance;
      ++counts->shadow;
      irradiance += light.irradiance * tracer_.Transmittance(shadow) * cosine;
    }
    return irradiance * kInversePi + shading_.ambient;
  }

  RTB_HD void ShadeMetal(const Pending& pending, const View& view,
                         const Rgb& f0) {
    const V3f& d = pending.ray.direction;
    const float cosine = std::min(1.0f, -d.dot(view.normal));
    PushBounce(pending, view, Reflect(d, view.normal),
               FresnelSchlick(f0, cosine));
  }

  RTB_HD void ShadeDielectric(const Pending& pending, const View& view,
                              const MaterialData& glass) {
    const V3f& d = pending.ray.direction;
    const float eta = view.from_outside ? 1 / glass.ior : glass.ior;
    const float cosine = std::min(1.0f, -d.dot(view.normal));
    const float f = FresnelDielectric(cosine, eta);
    PushBounce(pending, view, Reflect(d, view.normal), Rgb(f));
    if (f < 1) {
      PushBounce(pending, view, Refract(d, view.normal, eta),
                 glass.color * (1 - f));
    }
  }

  const Tracer& tracer_;
  const ShadingView shading_;
  const int max_depth_;
  int size_ = 0;
  // A popped ray pushes at most two, one level deeper.
  Pending stack_[kMaxDepth + 2];
};

}  // namespace rtb
