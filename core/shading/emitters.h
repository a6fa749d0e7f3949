/// @file
/// Choosing among all that emits - lights, emissive objects, the background -
/// and the density of that choice, host and device.
#pragma once

#include "core/accel/ray.h"
#include "core/base/host_device.h"
#include "core/math/discrete.h"
#include "core/shading/background.h"
#include "core/shading/interaction.h"
#include "core/shading/light.h"
#include "core/shading/shading_scene.h"
#include "core/shading/shadow_ray.h"

namespace rtb {

/// A direction towards something that emits.
struct EmitterSample {
  V3f direction{0};   ///< Unit.
  Ray shadow;         ///< What has to be free for its light to come through.
  Rgb irradiance{0};  ///< On a surface facing it, over the chance of choosing
                      ///< this one; black where there is nothing.
  float pdf = 0;      ///< Per solid angle; 0 for lights without extent.
};

/// One emitter as seen from a surface.
/// @param u uniforms; z chooses the emitter.
RTB_HD inline EmitterSample SampleEmitter(const ShadingView& shading,
                                          const SurfacePoint& point,
                                          const V3f& u) {
  const DiscreteSample choice =
      SampleDiscrete(shading.light_cdf, shading.light_count + 1, u.z);
  EmitterSample result;
  if (choice.index == shading.light_count) {
    const BackgroundSample sky =
        SampleBackground(shading.background, V2f(u.x, u.y));
    if (!(sky.pdf > 0)) return result;
    result.direction = sky.direction;
    result.shadow.origin = LeavingOrigin(point, sky.direction);
    result.shadow.direction = sky.direction;
    result.pdf = sky.pdf * choice.probability;
    result.irradiance = sky.radiance / result.pdf;
    return result;
  }
  const LightData& light = shading.lights[choice.index];
  const LightSample sample = SampleLight(light, point.position, V2f(u.x, u.y));
  result.direction = sample.direction;
  result.shadow = ShadowRay(point, light, sample);
  result.irradiance = sample.irradiance / choice.probability;
  result.pdf = sample.pdf * choice.probability;
  return result;
}

/// The density with which SampleEmitter chooses a direction that leaves the
/// scene.
RTB_HD inline float EscapePdf(const ShadingView& shading,
                              const V3f& direction) {
  return DiscreteProbability(shading.light_cdf, shading.light_count) *
         BackgroundPdf(shading.background, direction);
}

/// The entry of the lights that a hit belongs to; -1 = none.
RTB_HD inline int EmitterIndex(const ShadingView& shading,
                               const GeometryView& geometry, const Hit& hit,
                               const Interaction& at) {
  if (at.is_light) return geometry.objects[at.point.object].light;
  const int* list = nullptr;
  switch (hit.kind) {
    case PrimitiveKind::kTriangle:
      list = shading.triangle_emitters;
      break;
    case PrimitiveKind::kSphere:
      list = shading.sphere_emitters;
      break;
    case PrimitiveKind::kMesh: {
      if (shading.use_emitters == nullptr) return -1;
      const int first = shading.use_emitters[hit.use];
      return first < 0 ? -1 : first + hit.primitive;
    }
    default:
      break;
  }
  return list == nullptr ? -1 : list[hit.primitive];
}

/// The density with which SampleEmitter, from where the ray starts, chooses
/// the ray's direction to what it hits.
RTB_HD inline float EmitterPdf(const ShadingView& shading,
                               const GeometryView& geometry, const Ray& ray,
                               const Hit& hit, const Interaction& at) {
  const int index = EmitterIndex(shading, geometry, hit, at);
  if (index < 0) return 0;
  return DiscreteProbability(shading.light_cdf, index) *
         LightPdf(shading.lights[index], ray.origin, ray.direction, hit.t);
}

}  // namespace rtb
