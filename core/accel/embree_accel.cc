#include "core/accel/embree_accel.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/accel/intersect.h"
#include "core/base/check.h"

namespace rtb {
namespace {

/// Embree's geometry ids, in the order in which they are attached.
enum GeometryId : unsigned { kTriangles = 0, kSpheres = 1, kDisks = 2 };

/// Per-query context: carries what a shadow ray has lost so far.
struct Query {
  RTCIntersectContext context;  // first, so that callbacks can cast
  Rgb transmittance{1};
};

V3f Origin(RTCRayN* ray, unsigned n, unsigned i) {
  return V3f(RTCRayN_org_x(ray, n, i), RTCRayN_org_y(ray, n, i),
             RTCRayN_org_z(ray, n, i));
}

V3f Direction(RTCRayN* ray, unsigned n, unsigned i) {
  return V3f(RTCRayN_dir_x(ray, n, i), RTCRayN_dir_y(ray, n, i),
             RTCRayN_dir_z(ray, n, i));
}

PrimitiveKind KindOf(unsigned geometry_id) {
  switch (geometry_id) {
    case kTriangles:
      return PrimitiveKind::kTriangle;
    case kSpheres:
      return PrimitiveKind::kSphere;
    default:
      return PrimitiveKind::kDisk;
  }
}

}  // namespace

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
  bool Cross(int object, Query* query) const {
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

namespace {

using Impl = EmbreeAccel::Impl;

/// A kind of quadric: where its array is and how a line meets it.
struct SphereKind {
  static constexpr GeometryId kId = kSpheres;
  static const std::vector<Quadric>& Of(const Geometry& g) { return g.spheres; }
  static Roots Intersect(const Quadric& q, const V3f& o, const V3f& d) {
    return IntersectSphere(q, o, d);
  }
};
struct DiskKind {
  static constexpr GeometryId kId = kDisks;
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
  auto* query = reinterpret_cast<Query*>(args->context);
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
  auto* query = reinterpret_cast<Query*>(args->context);
  for (unsigned i = 0; i < args->N; ++i) {
    if (args->valid[i] == 0) continue;
    const unsigned triangle = RTCHitN_primID(args->hit, args->N, i);
    if (impl->Cross(impl->geometry->triangle_objects[triangle], query)) {
      args->valid[i] = 0;
    }
  }
}

void AttachTriangles(Impl* impl) {
  const Geometry& g = *impl->geometry;
  const std::size_t count = g.triangle_objects.size();
  if (count == 0) return;
  RTCGeometry geometry =
      rtcNewGeometry(impl->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<V3f*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                              RTC_FORMAT_FLOAT3, sizeof(V3f), 3 * count));
  auto* indices = static_cast<unsigned*>(
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0,
                              RTC_FORMAT_UINT3, 3 * sizeof(unsigned), count));
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
}

template <class Kind>
void AttachQuadrics(Impl* impl) {
  const std::size_t count = Kind::Of(*impl->geometry).size();
  if (count == 0) return;
  RTCGeometry geometry = rtcNewGeometry(impl->device, RTC_GEOMETRY_TYPE_USER);
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
}

RTCRay ToRtc(const Ray& ray) {
  RTCRay rtc{};
  rtc.org_x = ray.origin.x;
  rtc.org_y = ray.origin.y;
  rtc.org_z = ray.origin.z;
  rtc.dir_x = ray.direction.x;
  rtc.dir_y = ray.direction.y;
  rtc.dir_z = ray.direction.z;
  rtc.tnear = 0;
  rtc.tfar = ray.t_max;
  rtc.mask = 0xFFFFFFFFu;
  return rtc;
}

}  // namespace

EmbreeAccel::EmbreeAccel(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
EmbreeAccel::EmbreeAccel(EmbreeAccel&&) noexcept = default;
EmbreeAccel& EmbreeAccel::operator=(EmbreeAccel&&) noexcept = default;
EmbreeAccel::~EmbreeAccel() = default;

Result<EmbreeAccel> EmbreeAccel::Build(const Geometry& geometry,
                                       std::vector<Rgb> transmittance) {
  RTB_CHECK_EQ(transmittance.size(), geometry.objects.size());
  auto impl = std::make_unique<Impl>();
  // No "threads=N": that would bound every TBB loop of the process.
  impl->device = rtcNewDevice("");
  if (impl->device == nullptr) {
    return Fail(Failure(
        "embree",
        "no device: error " + std::to_string(rtcGetDeviceError(nullptr))));
  }
  impl->scene = rtcNewScene(impl->device);
  impl->geometry = &geometry;
  impl->view = ViewOf(geometry);
  impl->transmittance = std::move(transmittance);
  rtcSetSceneFlags(impl->scene, RTC_SCENE_FLAG_ROBUST);
  AttachTriangles(impl.get());
  AttachQuadrics<SphereKind>(impl.get());
  AttachQuadrics<DiskKind>(impl.get());
  rtcCommitScene(impl->scene);
  const RTCError error = rtcGetDeviceError(impl->device);
  if (error != RTC_ERROR_NONE) {
    return Fail(Failure("embree", error == RTC_ERROR_OUT_OF_MEMORY
                                      ? "out of memory"
                                      : "error " + std::to_string(error)));
  }
  return EmbreeAccel(std::move(impl));
}

Hit EmbreeAccel::Closest(const Ray& ray) const {
  Hit hit;
  IntersectPlanes(impl_->view, ray, &hit);
  RTCRayHit query{};
  query.ray = ToRtc(ray);
  if (hit.kind != PrimitiveKind::kNothing) query.ray.tfar = hit.t;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(impl_->scene, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return hit;
  return {KindOf(query.hit.geomID), static_cast<int>(query.hit.primID),
          query.ray.tfar, query.hit.u, query.hit.v};
}

Rgb EmbreeAccel::Transmittance(const Ray& ray) const {
  Query query;
  for (const PlaneData& plane : impl_->geometry->planes) {
    const Roots roots = IntersectPlane(plane, ray.origin, ray.direction);
    const bool crossed =
        roots.count > 0 && roots.t[0] > 0 && roots.t[0] < ray.t_max;
    if (crossed && !impl_->Cross(plane.object, &query)) return Rgb(0);
  }
  rtcInitIntersectContext(&query.context);
  RTCRay shadow = ToRtc(ray);
  rtcOccluded1(impl_->scene, &query.context, &shadow);
  return shadow.tfar < 0 ? Rgb(0) : query.transmittance;
}

const GeometryView& EmbreeAccel::geometry() const { return impl_->view; }

}  // namespace rtb
