/// @file
/// Triangles without an area: which they are, and how to be rid of them.
#pragma once

#include "core/scene/scene.h"

namespace rtb {

/// Whether a triangle has an area, and with it a normal. Reckoned in double
/// precision from the vertices as they are rendered, so that no finite
/// coordinate overflows or underflows; repeated vertices and vertices on one
/// line, up to the rounding of the calculation, make no area. A sliver whose
/// height is a rounding error of its decimal coordinates has one: without it
/// a closed mesh would be open there.
bool HasArea(const V3f& a, const V3f& b, const V3f& c);

/// Removes the triangles without an area; vertices stay.
/// @return how many there were.
int DropTrianglesWithoutArea(TriangleMesh* mesh);

}  // namespace rtb
