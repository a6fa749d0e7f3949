#include "core/accel/embree_accel.h"

#include <string>
#include <utility>

#include "core/accel/embree_impl.h"
#include "core/accel/intersect.h"
#include "core/accel/surface.h"
#include "core/base/check.h"
#include "core/base/parallel.h"

namespace rtb {
namespace {

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

Error EmbreeError(RTCError error) {
  if (error == RTC_ERROR_OUT_OF_MEMORY) {
    return Failure("embree", "not enough memory for the scene's geometry",
                   "use fewer or smaller meshes, or fewer instances");
  }
  return Failure("embree", "error " + std::to_string(error));
}

/// The error that made a call return nothing; without one, memory is short.
Error DeviceError(RTCDevice device) {
  const RTCError error = rtcGetDeviceError(device);
  return EmbreeError(error == RTC_ERROR_NONE ? RTC_ERROR_OUT_OF_MEMORY : error);
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
                                       std::vector<Rgb> transmittance,
                                       int threads) {
  RTB_CHECK_EQ(transmittance.size(), geometry.objects.size());
  auto impl = std::make_unique<Impl>();
  // No "threads=N": that would bound every TBB loop of the process.
  impl->device = rtcNewDevice("");
  if (impl->device == nullptr) return Fail(DeviceError(nullptr));
  impl->scene = rtcNewScene(impl->device);
  if (impl->scene == nullptr) return Fail(DeviceError(impl->device));
  impl->geometry = &geometry;
  impl->view = ViewOf(geometry);
  impl->transmittance = std::move(transmittance);
  rtcSetSceneFlags(impl->scene, RTC_SCENE_FLAG_ROBUST);
  if (!AttachGeometry(impl.get())) return Fail(DeviceError(impl->device));
  RunBounded(threads, [&] { rtcJoinCommitScene(impl->scene); });
  const RTCError error = rtcGetDeviceError(impl->device);
  if (error != RTC_ERROR_NONE) return Fail(EmbreeError(error));
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
  EmbreeQuery query;
  for (const PlaneData& plane : impl_->geometry->planes) {
    const Roots roots = IntersectPlane(plane, ray.origin, ray.direction);
    const bool crossed =
        roots.count > 0 && roots.t[0] > 0 && roots.t[0] < ray.t_max;
    if (crossed && !impl_->Cross(plane.object, &query)) return Rgb(0);
  }
  rtcInitIntersectContext(&query.context);
  RTCRay shadow = ToRtc(ray);
  rtcOccluded1(impl_->scene, &query.context, &shadow);
  if (shadow.tfar < 0) return Rgb(0);
  return query.crossed ? SteppedTransmittance(ray) : Rgb(1);
}

Rgb EmbreeAccel::SteppedTransmittance(Ray ray) const {
  Rgb left(1);
  while (left != Rgb(0) && ray.t_max > 0) {
    const Hit hit = Closest(ray);
    if (hit.kind == PrimitiveKind::kNothing) break;
    const SurfacePoint point = SurfaceAt(impl_->view, ray, hit);
    left *= impl_->transmittance[static_cast<std::size_t>(point.object)];
    ray.origin = LeavingOrigin(point, ray.direction);
    ray.t_max -= hit.t;
  }
  return left;
}

const GeometryView& EmbreeAccel::geometry() const { return impl_->view; }

}  // namespace rtb
