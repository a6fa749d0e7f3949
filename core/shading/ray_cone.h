/// @file
/// RayCone: how wide a beam a ray stands for, and what of a surface it covers.
/// Host and device.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/accel/surface_uv.h"
#include "core/base/host_device.h"
#include "core/math/vec.h"

namespace rtb {

/// A beam around a ray: Amanatides, "Ray Tracing with Cones", SIGGRAPH 1984;
/// as widths alone, Akenine-Moller et al., "Texture Level of Detail Strategies
/// for Real-Time Ray Tracing", Ray Tracing Gems, 2019, chapter 20. One of no
/// width is the ray itself.
struct RayCone {
  float width = 0;   ///< At the ray's origin, across it, in scene units.
  float spread = 0;  ///< Added to the width by each unit of length.

  /// The beam that goes on from a point that far along the ray, as from a flat
  /// mirror.
  RTB_HD RayCone At(float distance) const {
    return {width + spread * distance, spread};
  }
};

/// What a beam covers of a texture: conjugate diameters of an ellipse, in
/// texture coordinates.
struct UvFootprint {
  V2f a{0, 0};
  V2f b{0, 0};
};

/// The footprint of a beam.
/// @param normal,direction unit: of the surface and of the ray.
/// @param width of the beam at the surface.
RTB_HD inline UvFootprint FootprintOf(const SurfaceUv& surface,
                                      const V3f& normal, const V3f& direction,
                                      float width) {
  const float area = normal.dot(surface.dp_du.cross(surface.dp_dv));
  if (!(width > 0) || area == 0) return {};
  // Past that, no surface is seen edge-on.
  constexpr float kLeastCosine = 1e-3f;
  const float cosine = normal.dot(direction);
  const V3f tilt = direction - normal * cosine;
  const float sine = tilt.length();
  const V3f along = sine > 0 ? tilt / sine : TangentsOf(normal).s;
  const auto to_uv = [&](const V3f& v) {
    return V2f(normal.dot(v.cross(surface.dp_dv)),
               normal.dot(surface.dp_du.cross(v))) /
           area;
  };
  return {to_uv(along * (width / std::max(kLeastCosine, std::abs(cosine)))),
          to_uv(normal.cross(along) * width)};
}

}  // namespace rtb
