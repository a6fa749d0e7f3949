#include "core/cuda/device_geometry.h"

#include <cstddef>
#include <span>

namespace rtb {
namespace {

template <class T>
std::span<const T> ListOf(const T* first, int count) {
  if (first == nullptr) return {};
  return {first, static_cast<std::size_t>(count)};
}

}  // namespace

Status DeviceGeometry::Upload(const Geometry& geometry, const BvhAccel& accel,
                              cudaStream_t stream) {
  RTB_RETURN_IF_ERROR(UploadMeshes(geometry.meshes, stream));
  RTB_RETURN_IF_ERROR(UploadLists(geometry, {}, stream));
  RTB_RETURN_IF_ERROR(still_.Upload(accel.still(), {0, 0}, stream));
  mesh_tree_sizes_ = {0, 0};
  return UploadTrees(accel, stream);
}

Status DeviceGeometry::Move(const Geometry& geometry, const BvhAccel& accel,
                            cudaStream_t stream) {
  RTB_RETURN_IF_ERROR(UploadLists(geometry, geometry.still, stream));
  return UploadTrees(accel, stream);
}

Status DeviceGeometry::Trees::Upload(const BvhArrays& arrays,
                                     std::array<std::size_t, 2> same,
                                     cudaStream_t stream) {
  RTB_RETURN_IF_ERROR(nodes.Upload(std::span(arrays.nodes), stream, same[0]));
  return packs.Upload(std::span(arrays.packs), stream, same[1]);
}

Status DeviceGeometry::UploadMeshes(const std::vector<MeshData>& meshes,
                                    cudaStream_t stream) {
  mesh_lists_.resize(meshes.size());
  std::vector<MeshData> placed = meshes;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    Mesh& lists = mesh_lists_[i];
    MeshData& mesh = placed[i];
    const int vertices = mesh.vertex_count;
    RTB_RETURN_IF_ERROR(
        lists.positions.Upload(ListOf(mesh.positions, vertices), stream));
    RTB_RETURN_IF_ERROR(
        lists.normals.Upload(ListOf(mesh.normals, vertices), stream));
    RTB_RETURN_IF_ERROR(lists.uvs.Upload(ListOf(mesh.uvs, vertices), stream));
    RTB_RETURN_IF_ERROR(lists.triangles.Upload(
        ListOf(mesh.triangles, mesh.triangle_count), stream));
    mesh.positions = lists.positions.data();
    mesh.normals = lists.normals.data();  // null where there are none
    mesh.uvs = lists.uvs.data();
    mesh.triangles = lists.triangles.data();
  }
  RTB_RETURN_IF_ERROR(
      meshes_.Upload(std::span<const MeshData>(placed), stream));
  return FinishUploads(stream);  // `placed` ends here
}

Status DeviceGeometry::UploadLists(const Geometry& geometry,
                                   const GeometryCounts& same,
                                   cudaStream_t stream) {
  const auto upload = [stream](auto& array, const auto& list,
                               std::size_t known) {
    return array.Upload(std::span(list), stream, std::min(known, list.size()));
  };
  const std::size_t corners = 3 * same.triangles;
  RTB_RETURN_IF_ERROR(upload(vertices_, geometry.vertices, corners));
  RTB_RETURN_IF_ERROR(upload(uvs_, geometry.uvs, corners));
  RTB_RETURN_IF_ERROR(
      upload(triangle_objects_, geometry.triangle_objects, same.triangles));
  RTB_RETURN_IF_ERROR(upload(spheres_, geometry.spheres, same.spheres));
  RTB_RETURN_IF_ERROR(upload(disks_, geometry.disks, same.disks));
  RTB_RETURN_IF_ERROR(upload(planes_, geometry.planes, same.planes));
  RTB_RETURN_IF_ERROR(upload(uses_, geometry.uses, same.uses));
  return upload(objects_, geometry.objects, same.objects);
}

Status DeviceGeometry::UploadTrees(const BvhAccel& accel, cudaStream_t stream) {
  RTB_RETURN_IF_ERROR(moving_.Upload(accel.moving(), {0, 0}, stream));
  const BvhArrays& meshes = accel.meshes();
  RTB_RETURN_IF_ERROR(mesh_trees_.Upload(meshes, mesh_tree_sizes_, stream));
  mesh_tree_sizes_ = {meshes.nodes.size(), meshes.packs.size()};
  RTB_RETURN_IF_ERROR(mesh_roots_.Upload(accel.mesh_roots(), stream));
  RTB_RETURN_IF_ERROR(transmittance_.Upload(accel.transmittance(), stream));
  RenewView(accel);
  return {};
}

void DeviceGeometry::RenewView(const BvhAccel& accel) {
  view_ = accel.view();  // roots and counts; every pointer is replaced
  view_.still = still_.tables();
  view_.moving = moving_.tables();
  view_.meshes = mesh_trees_.tables();
  view_.mesh_roots = mesh_roots_.data();
  view_.transmittance = transmittance_.data();
  GeometryView& geometry = view_.geometry;
  geometry.vertices = vertices_.data();
  geometry.uvs = uvs_.data();
  geometry.triangle_objects = triangle_objects_.data();
  geometry.spheres = spheres_.data();
  geometry.disks = disks_.data();
  geometry.planes = planes_.data();
  geometry.meshes = meshes_.data();
  geometry.uses = uses_.data();
  geometry.objects = objects_.data();
}

}  // namespace rtb
