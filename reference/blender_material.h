/// @file
/// Materials and lights in the JSON that Blender's Python reads.
#pragma once

#include <nlohmann/json.hpp>

#include "core/base/result.h"
#include "core/scene/scene.h"
#include "reference/blender_images.h"

namespace rtb {

/// A material, in a world that is `scale` times as large.
/// @return an Error naming what Cycles cannot express.
Result<nlohmann::ordered_json> BlenderMaterial(const Scene& scene,
                                               const Material& material,
                                               const std::string& integrator,
                                               double scale,
                                               BlenderImages* images);

/// A light without a shape, moved by `offset`, in a world that is `scale`
/// times as large; null for one that has a shape.
nlohmann::ordered_json BlenderLamp(const Light& light, const V3d& offset,
                                   double scale);

/// The material of the shape of a light: it glows on its front.
nlohmann::ordered_json BlenderLightMaterial(const Light& light);

}  // namespace rtb
