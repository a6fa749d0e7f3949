/// @file
/// Movement: positions along paths and the camera at a time.
#pragma once

#include "core/scene/scene.h"

namespace rtb {

/// The offset that a path adds to its owner's position at `time` seconds.
V3d PathOffset(const Path& path, double time);

/// How far a light's path has moved it at `time`; zero without one.
V3d LightOffset(const Scene& scene, const Light& light, double time);

/// An orthonormal pinhole camera at one moment, in world space.
struct CameraFrame {
  V3d position;
  V3d right;    ///< Unit; to the right in the picture.
  V3d up;       ///< Unit; upwards in the picture.
  V3d forward;  ///< Unit view direction.
  double tan_half_vfov;
};

/// The scene's camera at `time`, paths applied. Where a path makes the view
/// direction vanish it is -z; where it runs along `up`, right is arbitrary.
CameraFrame CameraAt(const Scene& scene, double time);

}  // namespace rtb
