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
enum class PrimitiveKind {
  kNothing,
  kTriangle,
  kMesh,  ///< A triangle of a placed mesh.
  kSphere,
  kDisk,
  kPlane
};

/// The closest intersection along a ray, as the accelerator reports it.
struct Hit {
  PrimitiveKind kind = PrimitiveKind::kNothing;
  int primitive = -1;  ///< Among those of its kind; of a mesh, its triangle.
  float t = std::numeric_limits<float>::infinity();
  float u = 0, v = 0;  ///< Barycentric coordinates (triangles).
  int use = -1;        ///< Which placed mesh (kMesh).
};

/// The surface at a hit, in world space.
struct SurfacePoint {
  V3f position{0};  ///< On the surface, recomputed from the primitive.
  V3f normal{0};    ///< Unit geometric normal, outward / counter-clockwise.
  float scale = 0;  ///< Largest coordinate that entered `position`.
  int object = -1;  ///< Into Geometry's objects.
  /// Unit normal for shading, interpolated on a smooth mesh; on the side of
  /// `normal` but for grossly wrong vertex normals.
  V3f shading_normal{0};
};

/// An origin for a new ray that starts at `point` and leaves on the side of
/// `direction`: moved along the normal by a bound of the errors that make a
/// ray meet its own surface again. These are those of the point itself, which
/// is computed from the primitive (never from the ray's length), and those of
/// the next intersection: together under 16 units in the last place of the
/// largest coordinate that enters them. After Waechter and Binder, "A Fast and
/// Robust Method for Avoiding Self-Intersection", Ray Tracing Gems, 2019,
/// chapter 6; their 256 units cover points from barycentric coordinates of
/// unknown primitives, and are too coarse under grazing light.
RTB_HD inline V3f LeavingOrigin(const SurfacePoint& point,
                                const V3f& direction) {
  const float side = direction.dot(point.normal) < 0 ? -1.0f : 1.0f;
  return point.position + point.normal * (side * 0x1p-20f * point.scale);
}

}  // namespace rtb
