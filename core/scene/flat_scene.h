/// @file
/// FlatScene: a Scene composed at one time into primitives placed in the
/// world, the form that accelerators, renderers and exporters consume. Meshes
/// stay shared: each use names the mesh and its transform.
#pragma once

#include <array>
#include <vector>

#include "core/base/result.h"
#include "core/math/affine.h"
#include "core/scene/scene.h"

namespace rtb {

/// What the primitives of one object share.
struct FlatObject {
  Index material = kNone;   ///< Into Scene::materials; kNone = the default.
  Affined object_to_world;  ///< From the shape's own coordinates.
  Index light = kNone;      ///< Into Scene::lights: the shape of a light.
};

/// The unit sphere (centered at the origin) under an affine map.
struct FlatSphere {
  Affined unit_to_world;
  Index object = kNone;
};
/// The unit disk (z = 0, normal +z) under an affine map.
struct FlatDisk {
  Affined unit_to_world;
  Index object = kNone;
  double radius = 1;  ///< In the object's own coordinates.
};
/// An infinite plane in world space.
struct FlatPlane {
  V3d point;
  V3d normal;  ///< Unit.
  Index object = kNone;
  V3d own_point{0};         ///< `point` in the object's own coordinates.
  V3d own_normal{0, 1, 0};  ///< Unit normal there.
};
/// A triangle in world space; counter-clockwise seen from the front. Of the
/// small shapes: triangle, quad, polygon, box.
struct FlatTriangle {
  std::array<V3f, 3> vertices;
  Index object = kNone;
  std::array<V2f, 3> uvs = {V2f(0, 0), V2f(1, 0), V2f(0, 1)};
  /// Unit shading normals at the vertices; zero where there are none.
  std::array<V3f, 3> normals = {V3f(0, 0, 0), V3f(0, 0, 0), V3f(0, 0, 0)};
};
/// A mesh placed by its object's transform.
struct FlatMesh {
  Index mesh = kNone;  ///< Into Scene::meshes.
  Index object = kNone;
};

/// All primitives of a scene, or of a part of it, at one time.
struct FlatScene {
  std::vector<FlatObject> objects;
  std::vector<FlatSphere> spheres;
  std::vector<FlatDisk> disks;
  std::vector<FlatPlane> planes;
  std::vector<FlatTriangle> triangles;
  std::vector<FlatMesh> meshes;
};

/// A part of a scene: what stands still, or what a movement path of its own
/// or of an ancestor moves.
enum class FlatPart { kAll, kStill, kMoving };

/// Composes the scene's tree at `time`: transforms, inherited materials,
/// instances, paths; polygons become fans, boxes twelve triangles with
/// outward normals, quads two. Texture coordinates as the format defines them.
/// @return an Error when something leaves the range in which single precision
/// can square lengths.
Result<FlatScene> Flatten(const Scene& scene, double time,
                          FlatPart part = FlatPart::kAll);

/// Adds the shapes of the lights that have one (quad, sphere), which are seen
/// and block light as objects do.
Status AddLightShapes(const Scene& scene, double time, FlatPart part,
                      FlatScene* flat);

/// Puts every mesh's triangles, placed in the world, in its stead: for
/// consumers that know no instances.
/// @return an Error when there would be too many triangles.
Status ExpandMeshes(const Scene& scene, FlatScene* flat);

}  // namespace rtb
