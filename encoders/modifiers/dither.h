/// @file
/// Offsets that spread the error of a palette.
#pragma once

#include <cstdint>

#include "encoders/color_depth.h"
#include "encoders/modifiers/modifiers.h"

namespace rtb {

/// Half the distance between neighboring colors of a palette, in encoded
/// values: offsets run from minus to plus this.
double DitherAmplitude(ColorDepth depth);

/// The offset in (-1, 1) at one of the grid's dithered parts, counted over the
/// whole grid.
/// kBayer: Bayer, "An optimum method for two-level rendition of continuous-tone
/// pictures", ICC 1973, order 8. kRandom: uniform. 0 for the others.
double DitherOffset(Dither dither, int x, int y, std::uint64_t seed);

}  // namespace rtb
