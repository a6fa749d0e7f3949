/// @file
/// From a scene's lights to LightData, on the host.
#pragma once

#include "core/scene/scene.h"
#include "core/shading/light_data.h"

namespace rtb {

/// A light of the scene, moved by its path's offset.
LightData ToLightData(const Light& light, const V3d& offset);

/// One triangle of an emissive object, in world space.
LightData TriangleLight(const V3f& a, const V3f& b, const V3f& c,
                        const Rgb& radiance);

/// Luminance of the power that a light sends out, for choosing among lights:
/// exact but for the spot's penumbra, which counts by its half.
/// @param scene_radius what a light without falloff or position lights up, in
///     scene units.
double LightPower(const LightData& light, double scene_radius);

}  // namespace rtb
