/// @file
/// What embree_accel.cc and embree_attach.cc share; nobody else includes it.
#pragma once

#include <embree3/rtcore.h>

#include <algorithm>
#include <vector>

#include "core/accel/embree_accel.h"

namespace rtb {

/// Embree's geometry ids in the one scene.
enum EmbreeGeometryId : unsigned { kTriangles = 0, kSpheres = 1, kDisks = 2 };

/// Per-query context of a shadow ray.
struct EmbreeQuery {
  RTCIntersectContext context;  // first, so that callbacks can cast
  bool crossed = false;         ///< It met something transparent.
};

struct EmbreeAccel::Impl {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  const Geometry* geometry = nullptr;
  GeometryView view;
  std::vector<Rgb> transmittance;

  ~Impl() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }
  Impl() = default;
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  /// Notes that a shadow ray meets an object.
  /// @return whether any of its light gets through.
  bool Cross(int object, EmbreeQuery* query) const {
    if (transmittance[static_cast<std::size_t>(object)] == Rgb(0)) return false;
    query->crossed = true;
    return true;
  }

  bool AnyTransparentTriangle() const {
    return std::any_of(
        geometry->triangle_objects.begin(), geometry->triangle_objects.end(),
        [&](int object) {
          return transmittance[static_cast<std::size_t>(object)] != Rgb(0);
        });
  }
};

/// Attaches triangles, spheres and disks to the scene, with their callbacks.
/// @return whether Embree had the memory for it.
bool AttachGeometry(EmbreeAccel::Impl* impl);

}  // namespace rtb
