/// @file
/// The raster that samples at scattered places speak of. SeenSamples ->
/// Rebuild -> FitCell.
#pragma once

#include <vector>

#include "encoders/adaptive/samples.h"

namespace rtb {

/// sRGB-encoded colors of width x height sub-pixels a cell, row by row.
struct RebuiltRaster {
  int width = 0;   ///< Per cell.
  int height = 0;  ///< Per cell.
  std::vector<Rgb> encoded;

  std::span<const Rgb> cell(int index) const {
    const std::size_t size =
        static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    return std::span(encoded).subspan(static_cast<std::size_t>(index) * size,
                                      size);
  }
};

/// What to show where samples do not foretell one another.
enum class Texture {
  kExpected,  ///< Their mean, whose squared error is expected to be least.
  kKept,      ///< What the nearest ones show, which looks more like it.
};

/// Rebuilds the raster of every cell from the samples in it and around it.
RebuiltRaster Rebuild(const SeenSamples& samples, int width, int height,
                      double cell_aspect, Texture texture, int threads);

}  // namespace rtb
