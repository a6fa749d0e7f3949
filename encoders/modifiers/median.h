/// @file
/// Geometric medians as the colors of a cell.
#pragma once

#include <span>

#include "encoders/blend.h"
#include "encoders/cell.h"
#include "encoders/fit/atlas.h"

namespace rtb {

/// The point of least weighted sum of distances to the samples; one of them
/// where that is best. By Weiszfeld's iteration in the form of Vardi and
/// Zhang, "The multivariate L1-median and associated data depth", PNAS 97(4),
/// 2000, which does not stick at a sample.
/// @param weights >= 0, one for each sample, not all 0.
V3d GeometricMedian(std::span<const V3d> samples,
                    std::span<const double> weights);

/// The cell with each color the geometric median of the samples on its side.
/// A sample counts by how much more of it is on that side than on the other; a
/// side without such samples keeps its color.
/// @param samples in the blend space, one for each coverage of the mask.
Cell WithMedianColors(Cell cell, const FitMask& mask, Blend blend,
                      std::span<const V3d> samples);

}  // namespace rtb
