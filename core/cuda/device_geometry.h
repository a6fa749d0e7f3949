/// @file
/// DeviceGeometry: a Geometry and the BVH over it, mirrored on the device.
#pragma once

#include <cuda_runtime_api.h>

#include <array>
#include <vector>

#include "core/accel/bvh_accel.h"
#include "core/base/result.h"
#include "core/cuda/device_array.h"

namespace rtb {

/// What is uploaded once: all of it. What is uploaded when the scene moves:
/// the part that moves, which every list has at its end, and the tree over it.
class DeviceGeometry {
 public:
  /// Copies everything.
  Status Upload(const Geometry& geometry, const BvhAccel& accel,
                cudaStream_t stream);
  /// Copies what BvhAccel::Update may have changed since.
  Status Move(const Geometry& geometry, const BvhAccel& accel,
              cudaStream_t stream);

  /// The view in the device's pointers; valid until the next of these calls.
  const BvhView& view() const { return view_; }

 private:
  struct Trees {
    DeviceArray<BvhNode> nodes;
    DeviceArray<TrianglePack> packs;

    /// @param same nodes and packs that are there already.
    Status Upload(const BvhArrays& arrays, std::array<std::size_t, 2> same,
                  cudaStream_t stream);
    BvhTables tables() const { return {nodes.data(), packs.data()}; }
  };
  struct Mesh {
    DeviceArray<V3f> positions;
    DeviceArray<V3f> normals;
    DeviceArray<V2f> uvs;
    DeviceArray<std::array<int, 3>> triangles;
  };

  Status UploadMeshes(const std::vector<MeshData>& meshes, cudaStream_t stream);
  /// @param same how many of each list are there already.
  Status UploadLists(const Geometry& geometry, const GeometryCounts& same,
                     cudaStream_t stream);
  Status UploadTrees(const BvhAccel& accel, cudaStream_t stream);
  void RenewView(const BvhAccel& accel);

  DeviceArray<V3f> vertices_;
  DeviceArray<V2f> uvs_;
  DeviceArray<int> triangle_objects_;
  DeviceArray<Quadric> spheres_;
  DeviceArray<Quadric> disks_;
  DeviceArray<PlaneData> planes_;
  DeviceArray<MeshData> meshes_;
  DeviceArray<MeshUse> uses_;
  DeviceArray<ObjectData> objects_;
  DeviceArray<Rgb> transmittance_;
  DeviceArray<BvhRoot> mesh_roots_;
  std::vector<Mesh> mesh_lists_;
  Trees still_, moving_, mesh_trees_;
  std::array<std::size_t, 2> mesh_tree_sizes_ = {0, 0};
  BvhView view_;
};

}  // namespace rtb
