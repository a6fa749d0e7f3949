/// @file
/// Geometric conditions that the scene format sets.
#pragma once

#include <span>
#include <string>

#include "core/math/vec.h"

namespace rtb {

/// Whether two vectors span no area: the sine of their angle is at most 1e-7
/// (about the precision of rendering), or one of them is zero.
bool AreParallel(const V3d& a, const V3d& b);

/// Why the vertices make no polygon of the format (convex, planar within 1 %
/// of its diameter, no corner twice in a row); empty when they do.
std::string PolygonFault(std::span<const V3d> vertices);

}  // namespace rtb
