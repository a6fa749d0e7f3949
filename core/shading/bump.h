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

/// The slope of a grid's values per texel along u and v, by central differences
/// over half a texel to each side of the bilinear value: continuous.
/// @param p in texels.
RTB_HD inline V2f SlopePerTexel(const TexelGrid<float>& grid, const V2f& p) {
  const auto height = [&](float dx, float dy) {
    return Bilinear(grid, p.x + dx, p.y + dy, EdgeRule::kWrap);
  };
  // v runs against the rows.
  return {height(0.5f, 0) - height(-0.5f, 0),
          height(0, -0.5f) - height(0, 0.5f)};
}

/// (dh/du, dh/dv) in scene units per unit of u and v, averaged over a footprint
/// around (u, v). The mean slope is what a matte surface far away is shaded by,
/// as light on it is linear in small slopes.
RTB_HD_CALLED inline V2f HeightSlope(const BumpData& bump, const V2f& uv,
                                     const UvFootprint& footprint = {}) {
  const V2f texels = TexelsPerUv(bump, bump.scale);
  const TextureTaps taps = MakeTextureTaps(footprint, texels, bump.levels);
  const V2f slope = MeanOfTaps<V2f>(taps, uv, [&](int level, const V2f& at) {
    const TexelGrid<float> grid = LevelOf<float>(bump, level);
    return SlopePerTexel(grid, TexelPosition(grid, at, bump.scale)) *
           TexelsPerUv(grid, bump.scale);
  });
  return slope * bump.amount;
}

/// The perturbed unit shading normal: Blinn, "Simulation of Wrinkled
/// Surfaces", SIGGRAPH 1978, the equation of N', which leaves out terms
/// of second order. A height that rises along u tilts the
/// normal towards -dp/du.
/// @param dpdu, dpdv derivatives of the position, of either handedness.
/// @param normal unit, on the side that heights rise to: the surface's outward
///     one, not yet turned to the viewer. Returned where dp/du and dp/dv do
///     not span the surface.
/// @param footprint over which slopes are averaged.
RTB_HD inline V3f BumpNormal(const BumpData& bump, const V2f& uv,
                             const V3f& dpdu, const V3f& dpdv,
                             const V3f& normal,
                             const UvFootprint& footprint = {}) {
  const float area = normal.dot(dpdu.cross(dpdv));  // signed by handedness
  if (area == 0) return normal;
  const V2f slope = HeightSlope(bump, uv, footprint);
  const V3f tilt = normal.cross(dpdv) * slope.x - normal.cross(dpdu) * slope.y;
  const V3f perturbed = normal * std::abs(area) + tilt * (area < 0 ? -1 : 1);
  const float length = perturbed.length();
  return length > 0 && std::isfinite(length) ? perturbed / length : normal;
}

}  // namespace rtb
