/// @file
/// Geometry: a FlatScene in single precision, as plain arrays that host and
/// device code share.
#pragma once

#include <array>
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
};

/// An infinite plane.
struct PlaneData {
  V3f point{0};
  V3f normal{0};  ///< Unit.
  int object = -1;
};

/// What shading needs of an object.
struct ObjectData {
  int material = -1;
  Affinef world_to_object;
};

/// Everything an accelerator is built from.
struct Geometry {
  std::vector<V3f> vertices;          ///< Three per triangle.
  std::vector<int> triangle_objects;  ///< One per triangle.
  std::vector<Quadric> spheres;
  std::vector<Quadric> disks;
  std::vector<PlaneData> planes;
  std::vector<ObjectData> objects;
};

/// The same as bare pointers, for host and device code.
struct GeometryView {
  const V3f* vertices = nullptr;
  const int* triangle_objects = nullptr;
  const Quadric* spheres = nullptr;
  const Quadric* disks = nullptr;
  const PlaneData* planes = nullptr;
  const ObjectData* objects = nullptr;
  int plane_count = 0;
};

/// Converts a composed scene.
Geometry MakeGeometry(const FlatScene& flat);

/// A view of a Geometry, which must outlive it.
GeometryView ViewOf(const Geometry& geometry);

}  // namespace rtb
