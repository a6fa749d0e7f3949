/// @file
/// Reading of the geometry that a shape's own keys describe.
#pragma once

#include <array>
#include <span>
#include <string>

#include "core/scene/scene.h"
#include "core/scene/yaml_reader.h"

namespace rtb {

/// `edges`: two vectors that span a parallelogram.
std::array<V3d, 2> ReadEdges(MapReader& reader);

/// A shape without references to other parts of the file.
struct SimpleShape {
  std::string type;
  decltype(Object::shape) (*read)(MapReader&);
};

/// Sphere, plane, disk, triangle, quad, polygon and box.
std::span<const SimpleShape> SimpleShapes();

}  // namespace rtb
