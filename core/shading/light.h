/// @file
/// Sampling the lights of a scene, host and device: what next-event estimation
/// and multiple importance sampling ask of them.
#pragma once

#include "core/base/host_device.h"
#include "core/shading/light_area.h"
#include "core/shading/light_data.h"
#include "core/shading/light_point.h"
#include "core/shading/light_rectangle.h"
#include "core/shading/light_sphere.h"

namespace rtb {

/// The light as seen from `position`. Spheres and rectangles are sampled by
/// solid angle, other quads and triangles by area.
/// @param u of the unit square; lights without extent ignore it.
RTB_HD inline LightSample SampleLight(const LightData& light,
                                      const V3f& position,
                                      const V2f& u = V2f(0.5f)) {
  switch (light.model) {
    case LightModel::kPoint:
      return SamplePointLight(light, position);
    case LightModel::kDirectional:
      return SampleDirectionalLight(light);
    case LightModel::kSpot:
      return SampleSpotLight(light, position);
    case LightModel::kSphere:
      return SampleSphereLight(light, position, u);
    case LightModel::kQuad:
      if (light.rectangle) {
        const SphericalRectangle seen = SeenFrom(light, position);
        if (IsWide(seen)) return SampleRectangle(light, seen, u);
      }
      [[fallthrough]];
    case LightModel::kTriangle:
      return SampleArea(light, position, u);
  }
  return {};
}

/// The same, but every quad uniformly over its area, so that strata of the
/// unit square are strata of the light: what Whitted's `samples` ask for.
RTB_HD inline LightSample SampleLightByArea(const LightData& light,
                                            const V3f& position, const V2f& u) {
  return light.model == LightModel::kQuad ? SampleArea(light, position, u)
                                          : SampleLight(light, position, u);
}

/// The density per solid angle with which SampleLight chooses a direction that
/// hits the light, as multiple importance sampling needs it when a BSDF ray
/// has hit it; 0 for lights without extent and where no light comes from.
/// @param direction unit, from `position` to the point hit.
/// @param distance to that point.
RTB_HD inline float LightPdf(const LightData& light, const V3f& position,
                             const V3f& direction, float distance) {
  if (!HasExtent(light)) return 0;
  if (light.model == LightModel::kSphere) {
    return SphereLightPdf(light, position);
  }
  if (!ShinesAgainst(light, direction)) return 0;
  if (light.rectangle) {
    const SphericalRectangle seen = SeenFrom(light, position);
    if (IsWide(seen)) return 1 / seen.solid_angle;
  }
  return AreaPdf(light, direction, distance);
}

/// The density of SampleLightByArea, as LightPdf is that of SampleLight.
RTB_HD inline float LightPdfByArea(const LightData& light, const V3f& position,
                                   const V3f& direction, float distance) {
  if (light.model != LightModel::kQuad) {
    return LightPdf(light, position, direction, distance);
  }
  return ShinesAgainst(light, direction) ? AreaPdf(light, direction, distance)
                                         : 0;
}

/// The radiance of a light's surface for a ray that has hit it: quads on the
/// side of their normal, spheres from outside, triangles on both sides; 0 for
/// lights without extent, which are invisible.
/// @param direction of the ray, towards the light.
/// @param normal the surface's there: a quad's edge0 x edge1, a sphere's
///     outward one.
RTB_HD inline Rgb EmittedRadiance(const LightData& light, const V3f& direction,
                                  const V3f& normal) {
  if (!HasExtent(light)) return Rgb(0);
  const bool seen =
      light.model == LightModel::kTriangle || normal.dot(direction) < 0;
  return seen ? light.color : Rgb(0);
}

}  // namespace rtb
