/// @file
/// FlatScene: a Scene composed at one time into world-space primitives, the
/// form that accelerators, renderers and exporters of geometry consume.
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
};
/// An infinite plane in world space.
struct FlatPlane {
  V3d point;
  V3d normal;  ///< Unit.
  Index object = kNone;
};
/// A triangle in world space; counter-clockwise seen from the front.
struct FlatTriangle {
  std::array<V3f, 3> vertices;
  Index object = kNone;
};

/// All primitives of a scene at one time.
struct FlatScene {
  std::vector<FlatObject> objects;
  std::vector<FlatSphere> spheres;
  std::vector<FlatDisk> disks;
  std::vector<FlatPlane> planes;
  std::vector<FlatTriangle> triangles;
};

/// Composes the scene's tree at `time`: transforms, inherited materials,
/// instances, paths; polygons become fans, boxes twelve triangles with
/// outward normals, quads two.
/// @return an Error when something leaves the range in which single precision
/// can square lengths, or when there are too many triangles.
Result<FlatScene> Flatten(const Scene& scene, double time);

}  // namespace rtb
