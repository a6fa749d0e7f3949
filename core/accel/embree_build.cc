/// @file
/// Embree's scenes: one for each mesh, one for what stands still, one for what
/// moves.
#include <algorithm>
#include <utility>

#include "core/accel/embree_impl.h"
#include "core/base/parallel.h"

namespace rtb {
namespace {

using Impl = EmbreeAccel::Impl;

EmbreeScene NewScene(RTCDevice device) {
  EmbreeScene scene(rtcNewScene(device));
  if (scene.get() != nullptr) {
    rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
  }
  return scene;
}

/// The buffers of a triangle geometry; null when memory is short.
struct TriangleBuffers {
  V3f* vertices;
  std::array<unsigned, 3>* indices;
};

TriangleBuffers NewBuffers(RTCGeometry geometry, std::size_t vertices,
                           std::size_t triangles) {
  auto* v = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                    RTC_FORMAT_FLOAT3, sizeof(V3f), vertices);
  auto* i = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0,
                                    RTC_FORMAT_UINT3, 3 * sizeof(unsigned),
                                    triangles);
  return {static_cast<V3f*>(v), static_cast<std::array<unsigned, 3>*>(i)};
}

/// Lets shadow rays pass through transparent triangles.
void TriangleOccludedFilter(const RTCFilterFunctionNArguments* args) {
  auto* query = reinterpret_cast<EmbreeQuery*>(args->context);
  const EmbreePart& part = *query->part;
  const Impl& impl = *part.impl;
  for (unsigned i = 0; i < args->N; ++i) {
    if (args->valid[i] == 0) continue;
    const unsigned instance = RTCHitN_instID(args->hit, args->N, i, 0);
    const unsigned triangle = RTCHitN_primID(args->hit, args->N, i);
    const int object =
        instance == RTC_INVALID_GEOMETRY_ID
            ? impl.geometry->triangle_objects[part.begin.triangles + triangle]
            : impl.geometry->uses[part.begin.uses + instance - kFirstUse]
                  .object;
    if (impl.Cross(object, query)) args->valid[i] = 0;
  }
}

bool AnyTransparent(const Impl& impl) {
  return std::any_of(impl.transmittance.begin(), impl.transmittance.end(),
                     [](const Rgb& t) { return t != Rgb(0); });
}

/// A committed triangle geometry goes into a scene.
void Attach(RTCScene scene, RTCGeometry geometry, unsigned id, bool filtered) {
  if (filtered) {
    rtcSetGeometryOccludedFilterFunction(geometry, TriangleOccludedFilter);
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometryByID(scene, geometry, id);
  rtcReleaseGeometry(geometry);
}

bool BuildMesh(Impl* impl, const MeshData& mesh, EmbreeScene* scene,
               int threads) {
  *scene = NewScene(impl->device);
  if (scene->get() == nullptr) return false;
  RTCGeometry geometry =
      rtcNewGeometry(impl->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  if (geometry == nullptr) return false;
  const auto vertices = static_cast<std::size_t>(mesh.vertex_count);
  const auto triangles = static_cast<std::size_t>(mesh.triangle_count);
  const TriangleBuffers buffers = NewBuffers(geometry, vertices, triangles);
  if (buffers.vertices == nullptr || buffers.indices == nullptr) {
    rtcReleaseGeometry(geometry);
    return false;
  }
  std::copy_n(mesh.positions, vertices, buffers.vertices);
  for (std::size_t i = 0; i < triangles; ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    buffers.indices[i] = {static_cast<unsigned>(a), static_cast<unsigned>(b),
                          static_cast<unsigned>(c)};
  }
  Attach(scene->get(), geometry, kTriangles, AnyTransparent(*impl));
  RunBounded(threads, [&] { rtcJoinCommitScene(scene->get()); });
  return true;
}

/// Copies the part's triangles into the vertex buffer.
void FillVertices(const EmbreePart& part, V3f* vertices) {
  const V3f* from =
      part.impl->geometry->vertices.data() + 3 * part.begin.triangles;
  std::copy_n(from, 3 * (part.end.triangles - part.begin.triangles), vertices);
}

bool AttachTriangles(EmbreePart* part) {
  const std::size_t count = part->end.triangles - part->begin.triangles;
  if (count == 0) return true;
  RTCGeometry geometry =
      rtcNewGeometry(part->impl->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  if (geometry == nullptr) return false;
  const TriangleBuffers buffers = NewBuffers(geometry, 3 * count, count);
  if (buffers.vertices == nullptr || buffers.indices == nullptr) {
    rtcReleaseGeometry(geometry);
    return false;
  }
  FillVertices(*part, buffers.vertices);
  for (unsigned i = 0; i < count; ++i) {
    buffers.indices[i] = {3 * i, 3 * i + 1, 3 * i + 2};
  }
  Attach(part->scene.get(), geometry, kTriangles, AnyTransparent(*part->impl));
  return true;
}

void Place(RTCGeometry instance, const Affinef& m) {
  const float columns[12] = {m.x.x, m.x.y,      m.x.z,      m.y.x,
                             m.y.y, m.y.z,      m.z.x,      m.z.y,
                             m.z.z, m.origin.x, m.origin.y, m.origin.z};
  rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR,
                          columns);
  rtcCommitGeometry(instance);
}

bool AttachUses(EmbreePart* part) {
  Impl& impl = *part->impl;
  for (std::size_t i = part->begin.uses; i < part->end.uses; ++i) {
    const MeshUse& use = impl.geometry->uses[i];
    RTCGeometry instance =
        rtcNewGeometry(impl.device, RTC_GEOMETRY_TYPE_INSTANCE);
    if (instance == nullptr) return false;
    rtcSetGeometryInstancedScene(
        instance, impl.meshes[static_cast<std::size_t>(use.mesh)].get());
    rtcSetGeometryTimeStepCount(instance, 1);
    Place(instance, use.to_world);
    rtcAttachGeometryByID(
        part->scene.get(), instance,
        kFirstUse + static_cast<unsigned>(i - part->begin.uses));
    rtcReleaseGeometry(instance);
  }
  return true;
}

/// Moves a part's primitives to where Geometry has them now.
void MoveInPlace(EmbreePart* part) {
  RTCScene scene = part->scene.get();
  if (part->end.triangles > part->begin.triangles) {
    RTCGeometry geometry = rtcGetGeometry(scene, kTriangles);
    FillVertices(*part, static_cast<V3f*>(rtcGetGeometryBufferData(
                            geometry, RTC_BUFFER_TYPE_VERTEX, 0)));
    rtcUpdateGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0);
    rtcCommitGeometry(geometry);
  }
  if (part->end.spheres > part->begin.spheres) {
    rtcCommitGeometry(rtcGetGeometry(scene, kSpheres));
  }
  if (part->end.disks > part->begin.disks) {
    rtcCommitGeometry(rtcGetGeometry(scene, kDisks));
  }
  for (std::size_t i = part->begin.uses; i < part->end.uses; ++i) {
    const auto id = kFirstUse + static_cast<unsigned>(i - part->begin.uses);
    Place(rtcGetGeometry(scene, id), part->impl->geometry->uses[i].to_world);
  }
}

/// Where testing all primitives beats a tree of user geometry: each of its
/// leaves is a call through a pointer.
constexpr std::size_t kFewQuadrics = 8;

bool AreFewQuadrics(const GeometryCounts& begin, const GeometryCounts& end) {
  const std::size_t quadrics =
      end.spheres - begin.spheres + end.disks - begin.disks;
  return begin.triangles == end.triangles && begin.uses == end.uses &&
         quadrics <= kFewQuadrics;
}

}  // namespace

bool BuildMeshes(Impl* impl, std::size_t begin, std::size_t end, int threads) {
  const Geometry& geometry = *impl->geometry;
  impl->meshes.resize(geometry.meshes.size());
  for (std::size_t i = begin; i < end; ++i) {
    const auto mesh = static_cast<std::size_t>(geometry.uses[i].mesh);
    if (impl->meshes[mesh].get() != nullptr) continue;
    if (!BuildMesh(impl, geometry.meshes[mesh], &impl->meshes[mesh], threads)) {
      return false;
    }
  }
  return true;
}

bool BuildPart(EmbreePart* part, const GeometryCounts& begin,
               const GeometryCounts& end, int threads) {
  const bool same = !part->empty() && part->begin == begin && part->end == end;
  part->begin = begin;
  part->end = end;
  part->few = AreFewQuadrics(begin, end);
  if (part->few) {
    part->scene = {};
    return true;
  }
  if (same) {
    MoveInPlace(part);
  } else {
    part->scene = NewScene(part->impl->device);
    if (part->empty() || !AttachTriangles(part) || !AttachQuadrics(part) ||
        !AttachUses(part)) {
      return false;
    }
  }
  RunBounded(threads, [&] { rtcJoinCommitScene(part->scene.get()); });
  return true;
}

}  // namespace rtb
