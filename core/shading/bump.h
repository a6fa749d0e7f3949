/// @file
/// Bump maps: shading normals of a surface that a height map displaces.
#pragma once

#include <cmath>

#include "core/base/host_device.h"
#include "core/math/vec.h"
#include "core/shading/texture.h"

namespace rtb {

/// A height map: linear values, repeated in both directions.
struct BumpData : TexelGrid<float> {
  V2f scale{1, 1};   ///< Multiplies (u, v), as of the material's texture.
  float amount = 0;  ///< Height of value 1, in scene units.
};

/// (dh/du, dh/dv) in scene units per unit of u and v, by central differences
/// over half a texel to each side of the bilinear height: continuous.
RTB_HD inline V2f HeightSlope(const BumpData& bump, const V2f& uv) {
  const V2f p = TexelPosition(bump, uv, bump.scale);
  const auto height = [&](float dx, float dy) {
    return Bilinear(bump, p.x + dx, p.y + dy, EdgeRule::kWrap);
  };
  // Per texel, v against the rows; then texels per unit of u and v.
  const float right = height(0.5f, 0) - height(-0.5f, 0);
  const float up = height(0, -0.5f) - height(0, 0.5f);
  return V2f(right * bump.scale.x * static_cast<float>(bump.width),
             up * bump.scale.y * static_cast<float>(bump.height)) *
         bump.amount;
}

/// The perturbed unit shading normal: Blinn, "Simulation of Wrinkled
/// Surfaces", SIGGRAPH 1978, the equation of N', which leaves out terms
/// of second order. A height that rises along u tilts the
/// normal towards -dp/du.
/// @param dpdu, dpdv derivatives of the position, of either handedness.
/// @param normal unit, on the side that heights rise to: the surface's outward
///     one, not yet turned to the viewer. Returned where dp/du and dp/dv do
///     not span the surface.
RTB_HD inline V3f BumpNormal(const BumpData& bump, const V2f& uv,
                             const V3f& dpdu, const V3f& dpdv,
                             const V3f& normal) {
  const float area = normal.dot(dpdu.cross(dpdv));  // signed by handedness
  if (area == 0) return normal;
  const V2f slope = HeightSlope(bump, uv);
  const V3f tilt = normal.cross(dpdv) * slope.x - normal.cross(dpdu) * slope.y;
  const V3f perturbed = normal * std::abs(area) + tilt * (area < 0 ? -1 : 1);
  const float length = perturbed.length();
  return length > 0 && std::isfinite(length) ? perturbed / length : normal;
}

}  // namespace rtb
