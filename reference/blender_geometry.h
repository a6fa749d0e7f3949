/// @file
/// Shapes as triangles in the coordinates of their objects, for Blender.
#pragma once

#include <array>
#include <vector>

#include "core/scene/flat_scene.h"

namespace rtb {

/// Triangles with a texture coordinate for each corner.
struct BlenderMesh {
  std::vector<V3f> positions;
  std::vector<std::array<int, 3>> triangles;
  std::vector<V2f> uvs;      ///< Of each position, or none.
  std::vector<V3f> normals;  ///< Of each position, or none.
};

/// The sides of the polygon that stands for a disk, whose area it has: its
/// corners are 2e-5 radii off.
inline constexpr int kDiskSides = 512;

BlenderMesh BlenderDisk(const FlatScene& flat, const FlatDisk& disk);

/// Half the side of the square that stands for an infinite plane, in reaches.
inline constexpr double kPlaneReaches = 1e6;

/// Nested squares around the point of the plane nearest to the camera, each
/// twice as large as the one inside, so that positions are as precise
/// everywhere as pixels there are small.
/// @param reach how far the scene extends from the camera.
BlenderMesh BlenderPlane(const FlatScene& flat, const FlatPlane& plane,
                         const V3d& camera, double reach);

/// The triangles [begin, end), all of one object.
BlenderMesh BlenderTriangles(const FlatScene& flat, std::size_t begin,
                             std::size_t end);

/// A mesh as it is.
BlenderMesh BlenderMeshOf(const TriangleMesh& mesh);

}  // namespace rtb
