/// @file
/// Eye rays through a picture.
#pragma once

#include <cmath>

#include "core/accel/ray.h"
#include "core/base/host_device.h"
#include "core/scene/animation.h"

namespace rtb {

/// A pinhole camera scaled to a picture's aspect, in double precision: the
/// rounding of directions decides which side of a far edge a ray takes.
struct CameraRays {
  V3d position{0};
  V3d forward{0};
  V3d right{0};  ///< To the right border of the image plane.
  V3d up{0};     ///< To its upper border.
};

/// @param aspect width / height of the picture.
inline CameraRays MakeCameraRays(const CameraFrame& frame, double aspect) {
  const double half_height = frame.tan_half_vfov;
  return {frame.position, frame.forward, frame.right * (half_height * aspect),
          frame.up * half_height};
}

/// How much wider a beam of that share of the picture becomes by each unit of
/// length along its ray.
/// @param width,height of the picture, in [0, 1].
/// @param direction of the ray, unit.
RTB_HD inline float SpreadOf(const CameraRays& camera, double width,
                             double height, const V3f& direction) {
  // At unit depth the picture is 2 |right| x 2 |up|; the root of the area.
  const double at_depth = 2 * std::sqrt(width * height * camera.right.length() *
                                        camera.up.length());
  return static_cast<float>(at_depth * camera.forward.dot(V3d(direction)));
}

/// The ray through (x, y) of the picture: x to the right, y down, in [0, 1].
RTB_HD inline Ray EyeRay(const CameraRays& camera, double x, double y) {
  const V3d direction =
      camera.forward + camera.right * (2 * x - 1) + camera.up * (1 - 2 * y);
  Ray ray;
  ray.origin = V3f(camera.position);
  ray.direction = V3f(direction.normalized());
  return ray;
}

}  // namespace rtb
