/// @file
/// Encoders' inner loops by vectors: each lane encodes one cell. Highway
/// chooses the instruction set at run time. Every function gives the cells of
/// the scalar one that it names, for any samples; where single precision could
/// decide otherwise, it asks the scalar one. Samples are linear, unclipped, one
/// cell's after the other's; blending is in sRGB.
#pragma once

#include <span>

#include "core/color/srgb.h"
#include "core/math/vec.h"
#include "encoders/cell.h"

namespace rtb {

/// BestPartitionCell (partition.h) for 4, 6 or 8 samples a cell; `glyphs` has
/// one for each set of "on" samples: 16, 64 or 256.
void EncodePartitions(std::span<const Rgb> samples,
                      std::span<const char32_t> glyphs, std::span<Cell> cells);

/// BrightnessSplitCell (quadrant_split.h); `glyphs` has one for each set of
/// "on" samples.
void EncodeBrightnessSplits(std::span<const Rgb> samples,
                            std::span<const char32_t> glyphs,
                            std::span<Cell> cells);

/// TivCell (tiv_cell.h) of 32 8-bit pixels a cell.
void EncodeTivCells(std::span<const Rgb8> pixels, std::span<Cell> cells);

/// The instruction set in use, such as AVX3_DL.
const char* SimdTargetName();

}  // namespace rtb
