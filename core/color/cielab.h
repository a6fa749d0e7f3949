/// @file
/// CIE XYZ and CIELAB of BT.709 colors, in double precision.
#pragma once

#include "core/math/vec.h"

namespace rtb {

/// XYZ of linear (1, 1, 1): D65, 2 degrees, Y = 1. The value that FLIP's
/// authors use; every conversion here shares it.
inline constexpr double kWhiteX = 0.950428545;
inline constexpr double kWhiteY = 1.0;
inline constexpr double kWhiteZ = 1.088900371;

/// Linear BT.709 to XYZ.
V3d LinearToXyz(const V3d& linear);

/// XYZ to linear BT.709; colors outside the gamut have components outside
/// [0, 1].
V3d XyzToLinear(const V3d& xyz);

/// XYZ to CIELAB against the white above: L* in [0, 100], a*, b*.
V3d XyzToLab(const V3d& xyz);

/// Linear BT.709 to CIELAB.
V3d LinearToLab(const V3d& linear);

}  // namespace rtb
