/// @file
/// References by POV-Ray.
#pragma once

#include "core/base/result.h"
#include "core/scene/scene.h"
#include "reference/reference.h"

namespace rtb {

/// Renders a reference with POV-Ray in row bands that survive an interruption
/// (a second call with the same request continues), averages the samples of
/// each pixel in linear light, and writes a half-float EXR and a provenance
/// JSON, both atomically.
/// @return kMissing (with how to get it) when povray is not installed.
Status RenderPovReference(const Scene& scene, const ReferenceRequest& request,
                          const Progress& progress);

}  // namespace rtb
