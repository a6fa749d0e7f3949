/// @file
/// Geometry: a FlatScene in single precision, as plain arrays that host and
/// device code share.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/math/affine.h"
#include "core/scene/flat_scene.h"

namespace rtb {

/// The unit sphere or unit disk under an affine map. A point p of the world
/// is at linear (p - center) in unit space.
struct Quadric {
  V3f center{0};
  Affinef to_world;    ///< Linear part; its origin is 0.
  Affinef to_unit;     ///< Linear part; its origin is 0.
  V3f half_extent{0};  ///< Of the world-space bounding box.
  float scale = 0;     ///< Largest coordinate of the bounding box.
  int object = -1;
  float radius = 1;  ///< Of a disk, in the object's own coordinates.
};

/// An infinite plane.
struct PlaneData {
  V3f point{0};
  V3f normal{0};  ///< Unit.
  int object = -1;
  /// Texture coordinates: u = u_axis . (p - point), and where u grows by 1.
  V3f u_axis{0}, v_axis{0};
  V3f dp_du{0}, dp_dv{0};
};

/// A triangle mesh in coordinates of its own, owned by the Scene.
struct MeshData {
  const V3f* positions = nullptr;
  const V3f* normals = nullptr;  ///< Unit, per vertex; null = flat.
  const V2f* uvs = nullptr;      ///< Per vertex; null = none.
  const std::array<int, 3>* triangles = nullptr;
  int vertex_count = 0;
  int triangle_count = 0;
};

/// A mesh placed in the world; its object has the inverse map.
struct MeshUse {
  Affinef to_world;
  int mesh = -1;
  int object = -1;
};

/// What shading needs of an object.
struct ObjectData {
  int material = -1;
  int light = -1;  ///< The light whose shape it is; -1 = none.
  Affinef world_to_object;
};

/// How many of each kind.
struct GeometryCounts {
  std::size_t triangles = 0;
  std::size_t spheres = 0;
  std::size_t disks = 0;
  std::size_t planes = 0;
  std::size_t uses = 0;
  std::size_t objects = 0;
  bool operator==(const GeometryCounts&) const = default;
};

/// Everything an accelerator is built from. In every list what stands still
/// comes first, what moves after it.
struct Geometry {
  std::vector<V3f> vertices;          ///< Three per triangle.
  std::vector<V2f> uvs;               ///< Three per triangle.
  std::vector<int> triangle_objects;  ///< One per triangle.
  std::vector<Quadric> spheres;
  std::vector<Quadric> disks;
  std::vector<PlaneData> planes;
  std::vector<MeshData> meshes;
  std::vector<MeshUse> uses;
  std::vector<ObjectData> objects;
  GeometryCounts still;

  GeometryCounts counts() const;
};

/// The same as bare pointers, for host and device code.
struct GeometryView {
  const V3f* vertices = nullptr;
  const V2f* uvs = nullptr;
  const int* triangle_objects = nullptr;
  const Quadric* spheres = nullptr;
  const Quadric* disks = nullptr;
  const PlaneData* planes = nullptr;
  const MeshData* meshes = nullptr;
  const MeshUse* uses = nullptr;
  const ObjectData* objects = nullptr;
  int plane_count = 0;
};

/// Converts a composed scene, or its part that stands still.
/// @param meshes those that it names; they must outlive the Geometry.
Geometry MakeGeometry(const FlatScene& still,
                      std::span<const TriangleMesh> meshes = {});

/// Puts `moving` in place of what moved before.
void ReplaceMoving(const FlatScene& moving, Geometry* geometry);

/// A view of a Geometry, which must outlive it.
GeometryView ViewOf(const Geometry& geometry);

}  // namespace rtb
