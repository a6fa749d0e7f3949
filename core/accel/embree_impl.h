/// @file
/// What the embree_*.cc files share; nobody else includes it.
#pragma once

#include <embree3/rtcore.h>

#include <utility>
#include <vector>

#include "core/accel/embree_accel.h"

namespace rtb {

/// Embree's geometry ids in the scene of a part; placed meshes follow.
enum EmbreeGeometryId : unsigned {
  kTriangles = 0,
  kSpheres = 1,
  kDisks = 2,
  kFirstUse = 3
};

/// A scene of Embree that is released with its owner.
class EmbreeScene {
 public:
  EmbreeScene() = default;
  explicit EmbreeScene(RTCScene scene) : scene_(scene) {}
  EmbreeScene(EmbreeScene&& other) noexcept
      : scene_(std::exchange(other.scene_, nullptr)) {}
  EmbreeScene& operator=(EmbreeScene&& other) noexcept {
    std::swap(scene_, other.scene_);
    return *this;
  }
  ~EmbreeScene() {
    if (scene_ != nullptr) rtcReleaseScene(scene_);
  }
  RTCScene get() const { return scene_; }

 private:
  RTCScene scene_ = nullptr;
};

/// What stands still, or what moves: a scene of its own, so that movement
/// never rebuilds what stands still. Its primitives are numbers [begin, end)
/// of Geometry's lists.
struct EmbreePart {
  EmbreeAccel::Impl* impl = nullptr;
  EmbreeScene scene;
  GeometryCounts begin;
  GeometryCounts end;
  /// It is so few quadrics that rays test them all; it has no scene.
  bool few = false;

  bool empty() const { return scene.get() == nullptr; }
};

/// Per-query context of a shadow ray.
struct EmbreeQuery {
  RTCIntersectContext context;  // first, so that callbacks can cast
  const EmbreePart* part = nullptr;
  bool opaque = false;   ///< Nothing counts as transparent.
  bool crossed = false;  ///< It met something transparent.
};

struct EmbreeAccel::Impl {
  RTCDevice device = nullptr;
  /// One for each of Geometry's meshes that is placed somewhere.
  std::vector<EmbreeScene> meshes;
  EmbreePart still;
  EmbreePart moving;
  Geometry* geometry = nullptr;
  GeometryView view;
  std::vector<Rgb> transmittance;

  Impl() = default;
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() {
    still.scene = {};
    moving.scene = {};
    meshes.clear();
    if (device != nullptr) rtcReleaseDevice(device);
  }

  /// Notes that a shadow ray meets an object.
  /// @return whether any of its light gets through.
  bool Cross(int object, EmbreeQuery* query) const {
    if (query->opaque) return false;
    if (transmittance[static_cast<std::size_t>(object)] == Rgb(0)) return false;
    query->crossed = true;
    return true;
  }
};

/// Makes the scenes of the meshes that [begin, end) of the uses place, as far
/// as they are not there. @return whether Embree had the memory for it.
bool BuildMeshes(EmbreeAccel::Impl* impl, std::size_t begin, std::size_t end,
                 int threads);

/// Fills a part's scene, anew or, where its counts are the same, in place.
/// @return whether Embree had the memory for it.
bool BuildPart(EmbreePart* part, const GeometryCounts& begin,
               const GeometryCounts& end, int threads);

/// Attaches a part's spheres and disks to its scene.
bool AttachQuadrics(EmbreePart* part);

}  // namespace rtb
