/// @file
/// The vector types of the whole program: Imath's, under short names.
#pragma once

#include <Imath/ImathVec.h>

namespace rtb {

using V2f = Imath::V2f;
using V3f = Imath::V3f;
using V4f = Imath::V4f;
using V2d = Imath::V2d;
using V3d = Imath::V3d;

/// A color or radiance: three scene-linear BT.709 components.
using Rgb = Imath::V3f;

}  // namespace rtb
