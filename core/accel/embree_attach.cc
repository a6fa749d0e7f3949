#include <cmath>

#include "core/accel/embree_impl.h"
#include "core/accel/intersect.h"

namespace rtb {
namespace {

using Impl = EmbreeAccel::Impl;

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
  static const std::vector<Quadric>& Of(const Geometry& g) { return g.spheres; }
  static Roots Intersect(const Quadric& q, const V3f& o, const V3f& d) {
    return IntersectSphere(q, o, d);
  }
};
struct DiskKind {
  static constexpr EmbreeGeometryId kId = kDisks;
  static const std::vector<Quadric>& Of(const Geometry& g) { return g.disks; }
  static Roots Intersect(const Quadric& q, const V3f& o, const V3f& d) {
    return IntersectDisk(q, o, d);
  }
};

template <class Kind>
void QuadricBounds(const RTCBoundsFunctionArguments* args) {
  const auto* impl = static_cast<const Impl*>(args->geometryUserPtr);
  const Quadric& q = Kind::Of(*impl->geometry)[args->primID];
  // Room for the rounding of center, extent and transform.
  const float margin = 0x1p-18f * q.scale;
  const V3f low = q.center - q.half_extent - V3f(margin);
  const V3f high = q.center + q.half_extent + V3f(margin);
  *args->bounds_o = {low.x, low.y, low.z, 0, high.x, high.y, high.z, 0};
}

template <class Kind>
void QuadricIntersect(const RTCIntersectFunctionNArguments* args) {
  const auto* impl = static_cast<const Impl*>(args->geometryUserPtr);
  const Quadric& quadric = Kind::Of(*impl->geometry)[args->primID];
  const unsigned n = args->N;
  RTCRayN* ray = RTCRayHitN_RayN(args->rayhit, n);
  RTCHitN* hit = RTCRayHitN_HitN(args->rayhit, n);
  for (unsigned i = 0; i < n; ++i) {
    if (args->valid[i] == 0) continue;
    const Roots roots =
        Kind::Intersect(quadric, Origin(ray, n, i), Direction(ray, n, i));
    for (int k = 0; k < roots.count; ++k) {
      if (!(roots.t[k] > RTCRayN_tnear(ray, n, i))) continue;
      if (!(roots.t[k] < RTCRayN_tfar(ray, n, i))) break;
      RTCRayN_tfar(ray, n, i) = roots.t[k];
      RTCHitN_geomID(hit, n, i) = Kind::kId;
      RTCHitN_primID(hit, n, i) = args->primID;
      break;
    }
  }
}

template <class Kind>
void QuadricOccluded(const RTCOccludedFunctionNArguments* args) {
  const auto* impl = static_cast<const Impl*>(args->geometryUserPtr);
  const Quadric& quadric = Kind::Of(*impl->geometry)[args->primID];
  auto* query = reinterpret_cast<EmbreeQuery*>(args->context);
  const unsigned n = args->N;
  for (unsigned i = 0; i < n; ++i) {
    if (args->valid[i] == 0) continue;
    const Roots roots = Kind::Intersect(quadric, Origin(args->ray, n, i),
                                        Direction(args->ray, n, i));
    for (int k = 0; k < roots.count; ++k) {
      const float t = roots.t[k];
      if (!(t > RTCRayN_tnear(args->ray, n, i))) continue;
      if (!(t < RTCRayN_tfar(args->ray, n, i))) break;
      if (impl->Cross(quadric.object, query)) continue;
      RTCRayN_tfar(args->ray, n, i) = -INFINITY;
      break;
    }
  }
}

/// Lets shadow rays pass through transparent triangles.
void TriangleOccludedFilter(const RTCFilterFunctionNArguments* args) {
  const auto* impl = static_cast<const Impl*>(args->geometryUserPtr);
  auto* query = reinterpret_cast<EmbreeQuery*>(args->context);
  for (unsigned i = 0; i < args->N; ++i) {
    if (args->valid[i] == 0) continue;
    const unsigned triangle = RTCHitN_primID(args->hit, args->N, i);
    if (impl->Cross(impl->geometry->triangle_objects[triangle], query)) {
      args->valid[i] = 0;
    }
  }
}

bool AttachTriangles(Impl* impl) {
  const Geometry& g = *impl->geometry;
  const std::size_t count = g.triangle_objects.size();
  if (count == 0) return true;
  RTCGeometry geometry =
      rtcNewGeometry(impl->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  if (geometry == nullptr) return false;
  auto* vertices = static_cast<V3f*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                              RTC_FORMAT_FLOAT3, sizeof(V3f), 3 * count));
  auto* indices = static_cast<unsigned*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0,
                              RTC_FORMAT_UINT3, 3 * sizeof(unsigned), count));
  if (vertices == nullptr || indices == nullptr) {
    rtcReleaseGeometry(geometry);
    return false;
  }
  for (std::size_t i = 0; i < 3 * count; ++i) {
    vertices[i] = g.vertices[i];
    indices[i] = static_cast<unsigned>(i);
  }
  rtcSetGeometryUserData(geometry, impl);
  if (impl->AnyTransparentTriangle()) {
    rtcSetGeometryOccludedFilterFunction(geometry, TriangleOccludedFilter);
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(impl->scene, geometry, kTriangles);
  rtcReleaseGeometry(geometry);
  return true;
}

template <class Kind>
bool AttachQuadrics(Impl* impl) {
  const std::size_t count = Kind::Of(*impl->geometry).size();
  if (count == 0) return true;
  RTCGeometry geometry = rtcNewGeometry(impl->device, RTC_GEOMETRY_TYPE_USER);
  if (geometry == nullptr) return false;
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(count));
  rtcSetGeometryUserData(geometry, impl);
  rtcSetGeometryBoundsFunction(
      geometry,
      [](const RTCBoundsFunctionArguments* args) { QuadricBounds<Kind>(args); },
      nullptr);
  rtcSetGeometryIntersectFunction(geometry, QuadricIntersect<Kind>);
  rtcSetGeometryOccludedFunction(geometry, QuadricOccluded<Kind>);
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(impl->scene, geometry, Kind::kId);
  rtcReleaseGeometry(geometry);
  return true;
}

}  // namespace

bool AttachGeometry(EmbreeAccel::Impl* impl) {
  return AttachTriangles(impl) && AttachQuadrics<SphereKind>(impl) &&
         AttachQuadrics<DiskKind>(impl);
}

}  // namespace rtb
