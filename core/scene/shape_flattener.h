/// @file
/// From one shape of a Scene to primitives of a FlatScene.
#pragma once

#include "core/math/affine.h"
#include "core/scene/flat_scene.h"

namespace rtb {

/// Whether rendering in float can square a vector's length.
bool Representable(const V3d& v);

/// Whether a map and its inverse fit into single precision.
bool Representable(const Affined& map);

/// Appends the primitives of the object that was added to a FlatScene last.
class ShapeFlattener {
 public:
  /// All arguments must outlive it; `to_world` is the object's transform.
  ShapeFlattener(const Scene& scene, const Affined& to_world, FlatScene* flat)
      : scene_(scene),
        to_world_(to_world),
        object_(static_cast<Index>(flat->objects.size()) - 1),
        flat_(*flat) {}

  void operator()(const Sphere& sphere);
  void operator()(const Disk& disk);
  void operator()(const Plane& plane);
  void operator()(const Triangle& triangle);
  void operator()(const Quad& quad);
  void operator()(const Polygon& polygon);
  void operator()(const Box& box);
  void operator()(const Mesh& mesh);
  void operator()(const Group&) {}
  void operator()(const Instance&) {}

  /// Whether everything that was added fits into single precision.
  bool representable() const { return representable_; }

 private:
  struct Corner {
    V3d position;
    V2d uv;
  };
  /// The argument, noted when it leaves float's range.
  const V3d& Kept(const V3d& v);
  const Affined& Kept(const Affined& m);
  /// Adds a triangle of the object's own coordinates, unless it vanishes in
  /// single precision.
  void Add(const Corner& a, const Corner& b, const Corner& c);
  void AddQuad(const V3d& corner, const V3d& e0, const V3d& e1);

  const Scene& scene_;
  const Affined& to_world_;
  const Index object_;
  FlatScene& flat_;
  bool representable_ = true;
};

}  // namespace rtb
