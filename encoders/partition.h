/// @file
/// Two-way partitions of a cell's samples: the one of least squared error,
/// and the two colors that a partition gives.
#pragma once

#include <span>

#include "encoders/blend.h"
#include "encoders/cell.h"
#include "encoders/sample_mask.h"
#include "encoders/steps.h"

namespace rtb {

/// Of all partitions of at most 8 samples into two sides (one may be empty),
/// the one of least squared error around the sides' means; of equal ones, and
/// of the two masks that name one partition, the lower mask. 0 when the
/// samples are alike.
SampleMask BestPartition(std::span<const V3d> samples);

/// The same for sRGB-encoded samples, exactly: errors are equal when they are
/// the same number.
SampleMask BestPartition(std::span<const StepColor> samples);

/// `mask` or its complement, whichever side's mean has the higher HSP
/// brightness; the lower mask when they are equal. An empty side is the
/// darker one, so that a partition into all and none yields none (0).
SampleMask BrighterSide(Blend blend, std::span<const V3d> samples,
                        SampleMask mask);

/// The glyph with the mean of the samples in `on` as its foreground and the
/// mean of the others as its background. For an empty `on` the foreground is
/// black: nobody sees it.
Cell CellOfMeans(Blend blend, std::span<const V3d> samples, SampleMask on,
                 char32_t glyph);

/// The cell of the best partition of linear samples: `glyphs` has one for each
/// mask of "on" samples, and "on" is the brighter side.
Cell BestPartitionCell(Blend blend, std::span<const Rgb> linear,
                       std::span<const char32_t> glyphs);

}  // namespace rtb
