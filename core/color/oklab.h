/// @file
/// OKLab: a perceptual color space in which means and distances look even.
#pragma once

#include "core/math/vec.h"

namespace rtb {

/// Linear BT.709 to OKLab (L in [0, 1], a and b around 0) and back. Neither
/// clips. Source: B. Ottosson, "A perceptual color space for image
/// processing", 2020, with the matrices for linear sRGB.
/// @{
V3d LinearToOklab(const V3d& linear);
V3d OklabToLinear(const V3d& lab);
/// @}

}  // namespace rtb
