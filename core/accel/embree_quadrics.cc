/// @file
/// Spheres and disks as Embree's user geometry.
#include <cmath>

#include "core/accel/embree_impl.h"
#include "core/accel/intersect.h"

namespace rtb {
namespace {

V3f Origin(RTCRayN* ray, unsigned n, unsigned i) {
  return V3f(RTCRayN_org_x(ray, n, i), RTCRayN_org_y(ray, n, i),
             RTCRayN_org_z(ray, n, i));
}

V3f Direction(RTCRayN* ray, unsigned n, unsigned i) {
  return V3f(RTCRayN_dir_x(ray, n, i), RTCRayN_dir_y(ray, n, i),
             RTCRayN_dir_z(ray, n, i));
}

/// A kind of quadric: where its array is and how a line meets it.
struct SphereKind {
  static constexpr EmbreeGeometryId kId = kSpheres;
  static const Quadric& Of(const EmbreePart& part, unsigned i) {
    return part.impl->geometry->spheres[part.begin.spheres + i];
  }
  static std::size_t Count(const EmbreePart& part) {
    return part.end.spheres - part.begin.spheres;
  }
  static Roots Intersect(const Quadric& q, const V3f& o, const V3f& d) {
    return IntersectSphere(q, o, d);
  }
};
struct DiskKind {
  static constexpr EmbreeGeometryId kId = kDisks;
  static const Quadric& Of(const EmbreePart& part, unsigned i) {
    return part.impl->geometry->disks[part.begin.disks + i];
  }
  static std::size_t Count(const EmbreePart& part) {
    return part.end.disks - part.begin.disks;
  }
  static Roots Intersect(const Quadric& q, const V3f& o, const V3f& d) {
    return IntersectDisk(q, o, d);
  }
};

template <class Kind>
void QuadricBounds(const RTCBoundsFunctionArguments* args) {
  const auto* part = static_cast<const EmbreePart*>(args->geometryUserPtr);
  const Quadric& q = Kind::Of(*part, args->primID);
  // Room for the rounding of center, extent and transform.
  const float margin = 0x1p-18f * q.scale;
  const V3f low = q.center - q.half_extent - V3f(margin);
  const V3f high = q.center + q.half_extent + V3f(margin);
  *args->bounds_o = {low.x, low.y, low.z, 0, high.x, high.y, high.z, 0};
}

template <class Kind>
void QuadricIntersect(const RTCIntersectFunctionNArguments* args) {
  const auto* part = static_cast<const EmbreePart*>(args->geometryUserPtr);
  const Quadric& quadric = Kind::Of(*part, args->primID);
  const unsigned n = args->N;
  RTCRayN* ray = RTCRayHitN_RayN(args->rayhit, n);
  RTCHitN* hit = RTCRayHitN_HitN(args->rayhit, n);
  for (unsigned i = 0; i < n; ++i) {
    if (args->valid[i] == 0) continue;
    const Roots roots =
        Kind::Intersect(quadric, Origin(ray, n, i), Direction(ray, n, i));
    const float far = RTCRayN_tfar(ray, n, i);
    const float t = FirstBetween(roots, RTCRayN_tnear(ray, n, i), far);
    if (!(t < far)) continue;
    RTCRayN_tfar(ray, n, i) = t;
    RTCHitN_geomID(hit, n, i) = Kind::kId;
    RTCHitN_primID(hit, n, i) = args->primID;
    RTCHitN_instID(hit, n, i, 0) = RTC_INVALID_GEOMETRY_ID;
  }
}

template <class Kind>
void QuadricOccluded(const RTCOccludedFunctionNArguments* args) {
  const auto* part = static_cast<const EmbreePart*>(args->geometryUserPtr);
  const Quadric& quadric = Kind::Of(*part, args->primID);
  auto* query = reinterpret_cast<EmbreeQuery*>(args->context);
  const unsigned n = args->N;
  for (unsigned i = 0; i < n; ++i) {
    if (args->valid[i] == 0) continue;
    const Roots roots = Kind::Intersect(quadric, Origin(args->ray, n, i),
                                        Direction(args->ray, n, i));
    const float far = RTCRayN_tfar(args->ray, n, i);
    const float t = FirstBetween(roots, RTCRayN_tnear(args->ray, n, i), far);
    if (!(t < far) || part->impl->Cross(quadric.object, query)) continue;
    RTCRayN_tfar(args->ray, n, i) = -INFINITY;
  }
}

template <class Kind>
bool Attach(EmbreePart* part) {
  const std::size_t count = Kind::Count(*part);
  if (count == 0) return true;
  RTCGeometry geometry =
      rtcNewGeometry(part->impl->device, RTC_GEOMETRY_TYPE_USER);
  if (geometry == nullptr) return false;
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(count));
  rtcSetGeometryUserData(geometry, part);
  rtcSetGeometryBoundsFunction(
      geometry,
      [](const RTCBoundsFunctionArguments* args) { QuadricBounds<Kind>(args); },
      nullptr);
  rtcSetGeometryIntersectFunction(geometry, QuadricIntersect<Kind>);
  rtcSetGeometryOccludedFunction(geometry, QuadricOccluded<Kind>);
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(part->scene.get(), geometry, Kind::kId);
  rtcReleaseGeometry(geometry);
  return true;
}

}  // namespace

bool AttachQuadrics(EmbreePart* part) {
  return Attach<SphereKind>(part) && Attach<DiskKind>(part);
}

}  // namespace rtb
