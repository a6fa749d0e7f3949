/// @file
/// ControlMesh: the connected mesh that subdivision starts from.
#pragma once

#include <vector>

#include "core/scene/scene.h"

namespace rtb {

/// A mesh whose triangles are connected wherever their vertices are at the
/// same place; texture coordinates are indexed by themselves.
struct ControlMesh {
  std::vector<V3d> points;
  std::vector<int> point_corners;  ///< Three a triangle, into `points`.
  /// Texture coordinates of points, one for each chart that meets there.
  std::vector<V2d> uvs;
  std::vector<int> uv_corners;     ///< Into `uvs`; empty without them.
  std::vector<int> sharp_corners;  ///< Boundary points that stay, see below.
};

/// Connects a mesh: vertices of equal position become one point. Boundary
/// points where the boundary turns by more than 65 degrees are its sharp
/// corners: those of squares and pentagons, not those of hexagons.
ControlMesh Connect(const TriangleMesh& mesh);

}  // namespace rtb
