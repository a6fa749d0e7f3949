/// @file
/// Loop subdivision of triangle meshes, through OpenSubdiv (Far).
#pragma once

#include <cstddef>
#include <string>

#include "core/base/result.h"
#include "core/scene/scene.h"

namespace rtb {

/// Most triangles of one mesh: what fits into the memory of common machines.
inline constexpr std::size_t kMaxMeshTriangles = std::size_t{1} << 26;

/// Whether a mesh of so many triangles may be subdivided `levels` times: each
/// level makes four triangles of one.
/// @param file names the mesh in the error.
Status CheckSubdivision(std::size_t triangles, int levels,
                        const std::string& file);

/// Subdivides `levels` (1..6) times by Loop's scheme and moves the vertices to
/// the limit surface, so that further levels add vertices and move none.
///
/// - Vertices of equal position are one: the mesh's normals and the splits
///   that normals or texture coordinates made do not count.
/// - Along boundaries the limit is the cubic B-spline of the boundary's
///   vertices. It passes through corners: boundary vertices of only one
///   triangle (OpenSubdiv's VTX_BOUNDARY_EDGE_AND_CORNER), and those where the
///   boundary turns by more than 65 degrees, however the faces around were
///   triangulated: a square stays a square.
/// - Edges that more than two triangles share, or two of opposite winding,
///   stay sharp.
/// - Texture coordinates follow the rules of positions (so they stay affine
///   where they were); along seams those of boundaries, whose ends and
///   junctions of three charts stay put (FVAR_LINEAR_CORNERS_PLUS1).
/// @param mesh triangles with an area each, at least one.
/// @param smooth gives vertices the unit normals of the limit surface;
/// otherwise there are none.
/// @return an Error that names the file when the mesh would get too large or
/// OpenSubdiv refuses it. Triangles may have lost their area to rounding.
Result<TriangleMesh> Subdivide(const TriangleMesh& mesh, int levels,
                               bool smooth, const std::string& file);

}  // namespace rtb
