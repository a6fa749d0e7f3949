/// @file
/// Boxes around a Geometry's primitives, for the builder.
#pragma once

#include <span>
#include <vector>

#include "core/accel/bvh_builder.h"
#include "core/accel/geometry.h"

namespace rtb {

/// The triangles of a mesh, in its own coordinates.
std::vector<BvhPrimitive> MeshBoxes(const MeshData& mesh);

/// Primitives [begin, end) of a geometry's lists but planes, in the world;
/// indices are the geometry's. Boxes have room for the rounding of centers,
/// extents and transforms.
/// @param mesh_roots of all meshes that are placed, into mesh_nodes.
std::vector<BvhPrimitive> PartBoxes(const Geometry& geometry,
                                    std::span<const BvhRoot> mesh_roots,
                                    const std::vector<BvhNode>& mesh_nodes,
                                    const GeometryCounts& begin,
                                    const GeometryCounts& end);

/// The corners of a mesh's triangles; valid while the mesh is.
TriangleCorners CornersOf(const MeshData& mesh);
/// The corners of a geometry's own triangles; valid while the geometry is.
TriangleCorners CornersOf(const Geometry& geometry);

}  // namespace rtb
