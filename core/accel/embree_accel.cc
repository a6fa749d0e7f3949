#include "core/accel/embree_accel.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/accel/embree_impl.h"
#include "core/accel/intersect.h"
#include "core/accel/stepped_transmittance.h"
#include "core/base/check.h"
#include "core/base/parallel.h"

namespace rtb {
namespace {

/// The hit that Embree reports for a ray in a part.
Hit ToHit(const EmbreePart& part, const RTCRayHit& query) {
  const auto primitive = static_cast<std::size_t>(query.hit.primID);
  const auto make = [&](PrimitiveKind kind, std::size_t first) {
    return Hit{kind,           static_cast<int>(first + primitive),
               query.ray.tfar, query.hit.u,
               query.hit.v,    -1};
  };
  if (query.hit.instID[0] != RTC_INVALID_GEOMETRY_ID) {
    Hit hit = make(PrimitiveKind::kMesh, 0);
    hit.use =
        static_cast<int>(part.begin.uses + query.hit.instID[0] - kFirstUse);
    return hit;
  }
  switch (query.hit.geomID) {
    case kTriangles:
      return make(PrimitiveKind::kTriangle, part.begin.triangles);
    case kSpheres:
      return make(PrimitiveKind::kSphere, part.begin.spheres);
    default:
      return make(PrimitiveKind::kDisk, part.begin.disks);
  }
}

/// Keeps the closest hit with one kind's quadrics [begin, end).
template <class Intersect>
void ClosestOf(const std::vector<Quadric>& quadrics, std::size_t begin,
               std::size_t end, PrimitiveKind kind, const Intersect& intersect,
               const Ray& ray, Hit* hit) {
  for (std::size_t i = begin; i < end; ++i) {
    const Roots roots = intersect(quadrics[i], ray.origin, ray.direction);
    const float far = std::min(ray.t_max, hit->t);
    const float t = FirstBetween(roots, 0, far);
    if (t < far) *hit = {kind, static_cast<int>(i), t, 0, 0, -1};
  }
}

void ClosestOfFew(const EmbreePart& part, const Ray& ray, Hit* hit) {
  const Geometry& g = *part.impl->geometry;
  ClosestOf(g.spheres, part.begin.spheres, part.end.spheres,
            PrimitiveKind::kSphere, IntersectSphere, ray, hit);
  ClosestOf(g.disks, part.begin.disks, part.end.disks, PrimitiveKind::kDisk,
            IntersectDisk, ray, hit);
}

/// Whether one kind's quadrics [begin, end) let nothing through.
template <class Intersect>
bool BlockedBy(const std::vector<Quadric>& quadrics, std::size_t begin,
               std::size_t end, const Intersect& intersect,
               const EmbreeAccel::Impl& impl, const Ray& ray,
               EmbreeQuery* query) {
  for (std::size_t i = begin; i < end; ++i) {
    const Roots roots = intersect(quadrics[i], ray.origin, ray.direction);
    const bool crossed = FirstBetween(roots, 0, ray.t_max) < ray.t_max;
    if (crossed && !impl.Cross(quadrics[i].object, query)) return true;
  }
  return false;
}

bool BlockedByFew(const EmbreePart& part, const Ray& ray, EmbreeQuery* query) {
  const Geometry& g = *part.impl->geometry;
  return BlockedBy(g.spheres, part.begin.spheres, part.end.spheres,
                   IntersectSphere, *part.impl, ray, query) ||
         BlockedBy(g.disks, part.begin.disks, part.end.disks, IntersectDisk,
                   *part.impl, ray, query);
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

Result<EmbreeAccel> EmbreeAccel::Build(Geometry& geometry,
                                       std::vector<Rgb> transmittance,
                                       int threads) {
  auto impl = std::make_unique<Impl>();
  // No "threads=N": that would bound every TBB loop of the process.
  impl->device = rtcNewDevice("");
  if (impl->device == nullptr) return Fail(DeviceError(nullptr));
  impl->geometry = &geometry;
  impl->still.impl = impl.get();
  impl->moving.impl = impl.get();
  impl->transmittance = transmittance;
  const GeometryCounts& still = geometry.still;
  if (!BuildMeshes(impl.get(), 0, still.uses, threads) ||
      !BuildPart(&impl->still, {}, still, threads)) {
    return Fail(DeviceError(impl->device));
  }
  EmbreeAccel accel(std::move(impl));
  RTB_RETURN_IF_ERROR(accel.Update(std::move(transmittance), threads));
  return accel;
}

Status EmbreeAccel::Update(std::vector<Rgb> transmittance, int threads) {
  RTB_CHECK_EQ(transmittance.size(), impl_->geometry->objects.size());
  impl_->transmittance = std::move(transmittance);
  impl_->view = ViewOf(*impl_->geometry);
  const GeometryCounts all = impl_->geometry->counts();
  const GeometryCounts& still = impl_->geometry->still;
  if (!BuildMeshes(impl_.get(), still.uses, all.uses, threads) ||
      !BuildPart(&impl_->moving, still, all, threads)) {
    return Fail(DeviceError(impl_->device));
  }
  const RTCError error = rtcGetDeviceError(impl_->device);
  if (error != RTC_ERROR_NONE) return Fail(EmbreeError(error));
  return {};
}

Hit EmbreeAccel::Closest(const Ray& ray) const {
  Hit hit;
  IntersectPlanes(impl_->view, ray, &hit);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  for (const EmbreePart* part : {&impl_->still, &impl_->moving}) {
    if (part->few) {
      ClosestOfFew(*part, ray, &hit);
      continue;
    }
    RTCRayHit query{};
    query.ray = ToRtc(ray);
    if (hit.kind != PrimitiveKind::kNothing) query.ray.tfar = hit.t;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(part->scene.get(), &context, &query);
    if (query.hit.geomID != RTC_INVALID_GEOMETRY_ID) hit = ToHit(*part, query);
  }
  return hit;
}

bool EmbreeAccel::Blocked(const Ray& ray, EmbreeQuery* query) const {
  const auto cross = [&](int object) { return !impl_->Cross(object, query); };
  if (BlockedByPlanes(impl_->view, ray, cross)) return true;
  rtcInitIntersectContext(&query->context);
  for (const EmbreePart* part : {&impl_->still, &impl_->moving}) {
    if (part->few) {
      if (BlockedByFew(*part, ray, query)) return true;
      continue;
    }
    query->part = part;
    RTCRay shadow = ToRtc(ray);
    rtcOccluded1(part->scene.get(), &query->context, &shadow);
    if (shadow.tfar < 0) return true;
  }
  return false;
}

bool EmbreeAccel::Occluded(const Ray& ray) const {
  EmbreeQuery query;
  query.opaque = true;
  return ray.t_max > 0 && Blocked(ray, &query);
}

Rgb EmbreeAccel::Transmittance(const Ray& ray) const {
  EmbreeQuery query;
  if (ray.t_max > 0 && Blocked(ray, &query)) return Rgb(0);
  if (!query.crossed) return Rgb(1);
  return SteppedTransmittance(*this, impl_->transmittance.data(), ray);
}

const GeometryView& EmbreeAccel::geometry() const { return impl_->view; }

const Geometry& EmbreeAccel::whole_geometry() const { return *impl_->geometry; }

}  // namespace rtb
