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

/// Per-query context: carries what a shadow ray has lost so far.
struct EmbreeQuery {
  RTCIntersectContext context;  // first, so that callbacks can cast
  Rgb transmittance{1};
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

  /// Multiplies a shadow ray's transmittance by an object's.
  /// @return whether anything is left.
  bool Cross(int object, EmbreeQuery* query) const {
    query->transmittance *= transmittance[static_cast<std::size_t>(object)];
    return query->transmittance != Rgb(0);
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
void AttachGeometry(EmbreeAccel::Impl* impl);

}  // namespace rtb
