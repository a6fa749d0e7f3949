/// @file
/// Which of a cell's 2 x 2 samples are on, by a threshold on one value a
/// sample: what encoder `quadrant` does with one cell.
#pragma once

#include <span>

#include "encoders/blend.h"
#include "encoders/cell.h"

namespace rtb {

inline constexpr int kQuadrants = 4;

/// On are the linear samples of which the HSP brightness is greater than the
/// mean of the four. `glyphs` has one for each of the 16 masks.
Cell BrightnessSplitCell(Blend blend, std::span<const Rgb> linear,
                         std::span<const char32_t> glyphs);

/// Split are the samples at the middle of the sRGB-encoded channel of the
/// largest range (the first of equal ones); on is the brighter side.
Cell RangeSplitCell(Blend blend, std::span<const Rgb> linear,
                    std::span<const char32_t> glyphs);

}  // namespace rtb
