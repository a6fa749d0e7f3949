/// @file
/// How fast to walk through a scene.
#pragma once

#include "core/scene/scene.h"

namespace rtb {

/// Units per second: the camera's `speed`, else a tenth of the diagonal of
/// the box around all objects that have an end.
double SceneSpeed(const Scene& scene);

}  // namespace rtb
