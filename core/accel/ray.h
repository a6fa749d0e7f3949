/// @file
/// Rays and what they meet.
#pragma once

#include <limits>

#include "core/base/host_device.h"
#include "core/math/vec.h"

namespace rtb {

/// A ray origin + t direction, 0 < t < t_max. The direction is a unit vector.
struct Ray {
  V3f origin{0};
  V3f direction{0, 0, -1};
  float t_max = std::numeric_limits<float>::infinity();
};

/// The kinds of primitives that an accelerator tells apart.
enum class PrimitiveKind { kNothing, kTriangle, kSphere, kDisk, kPlane };

/// The closest intersection along a ray, as the accelerator reports it.
struct Hit {
  PrimitiveKind kind = PrimitiveKind::kNothing;
  int primitive = -1;  ///< Index among the primitives of its kind.
  float t = std::numeric_limits<float>::infinity();
  float u = 0, v = 0;  ///< Barycentric coordinates (triangles).
};

/// The surface at a hit, in world space.
struct SurfacePoint {
  V3f position{0};  ///< On the surface, recomputed from the primitive.
  V3f normal{0};    ///< Unit geometric normal, outward / counter-clockwise.
  float scale = 0;  ///< Largest coordinate that entered `position`.
  int object = -1;  ///< Into Geometry's objects.
};

/// An origin for a new ray that starts at `point` and leaves on the side of
/// `direction`: moved along the normal by 2^-16 of the coordinates that the
/// point was computed from, 256 units in the last place, which bounds the
/// error of the point. The constant is that of Waechter and Binder, "A Fast
/// and Robust Method for Avoiding Self-Intersection", Ray Tracing Gems, 2019,
/// chapter 6; taking the primitive's own scale in place of an absolute limit
/// near the origin makes it hold at every scale of scene.
RTB_HD inline V3f LeavingOrigin(const SurfacePoint& point,
                                const V3f& direction) {
  const float side = direction.dot(point.normal) < 0 ? -1.0f : 1.0f;
  return point.position + point.normal * (side * 0x1p-16f * point.scale);
}

}  // namespace rtb
