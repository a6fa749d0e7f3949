/// @file
/// SampleRaster: what an encoder saw, as a raster of each cell.
#pragma once

#include <vector>

#include "encoders/blend.h"
#include "encoders/evidence.h"

namespace rtb {

/// width x height colors of the blend space for each cell, row by row. The
/// encoder's own samples where they form a raster, else 8 x 16 sub-pixels that
/// each show the nearest sample of their cell.
struct SampleRaster {
  GridSize grid;
  int width = 0;   ///< Per cell.
  int height = 0;  ///< Per cell.
  std::vector<V3d> values;

  std::span<V3d> cell(int index) {
    return std::span(values).subspan(static_cast<std::size_t>(index) * size(),
                                     size());
  }
  std::span<const V3d> cell(int index) const {
    return std::span(values).subspan(static_cast<std::size_t>(index) * size(),
                                     size());
  }

 private:
  std::size_t size() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
};

/// Rasterizes evidence at width x height sub-pixels a cell, each of which shows
/// the nearest sample of its cell, cells being twice as high as wide.
SampleRaster NearestRaster(const Evidence& evidence, int width, int height,
                           Blend blend, int threads);

/// Rasterizes evidence.
SampleRaster RasterOf(const Evidence& evidence, Blend blend, int threads);

}  // namespace rtb
