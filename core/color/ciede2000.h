/// @file
/// The CIEDE2000 color difference.
#pragma once

#include "core/math/vec.h"

namespace rtb {

/// CIEDE2000 between two CIELAB colors, kL = kC = kH = 1, after Sharma, Wu and
/// Dalal, "The CIEDE2000 Color-Difference Formula: Implementation Notes,
/// Supplementary Test Data, and Mathematical Observations", Color Research and
/// Application 30(1), 2005. Hues exactly opposite count as 180 degrees apart,
/// not more.
double Ciede2000(const V3d& lab1, const V3d& lab2);

}  // namespace rtb
