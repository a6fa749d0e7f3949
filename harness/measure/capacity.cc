#include "harness/measure/capacity.h"

#include <set>

#include "encoders/fit/fit.h"
#include "harness/metrics/rows.h"

namespace rtb {
namespace {

/// The pixels of one cell, row by row.
void CopyCell(const Image& raster, int left, int top, int width, int height,
              std::vector<V3d>& samples) {
  samples.clear();
  for (int y = top; y < top + height; ++y) {
    for (int x = left; x < left + width; ++x) {
      samples.emplace_back(raster.at(x, y));
    }
  }
}

/// Mean over pixels and channels of error(column, row, samples).
template <class CellError>
double MeanOverCells(const Image& raster, GridSize grid, const Atlas& atlas,
                     int threads, const CellError& error) {
  RTB_CHECK_EQ(raster.width(), grid.columns * atlas.width());
  RTB_CHECK_EQ(raster.height(), grid.rows * atlas.height());
  const double sum = SumRows(grid.rows, threads, [&](int row) {
    std::vector<V3d> samples;
    double of_row = 0;
    for (int column = 0; column < grid.columns; ++column) {
      CopyCell(raster, column * atlas.width(), row * atlas.height(),
               atlas.width(), atlas.height(), samples);
      of_row += error(column, row, samples);
    }
    return of_row;
  });
  return sum / (3.0 * static_cast<double>(raster.pixels().size()));
}

}  // namespace

std::vector<char32_t> GlyphsOfRun(const Encoder& encoder,
                                  const CellGrid& grid) {
  const std::vector<char32_t> candidates = encoder.Candidates();
  std::set<char32_t> glyphs(candidates.begin(), candidates.end());
  for (const Cell& cell : grid.cells) glyphs.insert(cell.glyph);
  return {glyphs.begin(), glyphs.end()};
}

double Capacity(const Image& raster, GridSize grid, const Atlas& atlas,
                int threads) {
  return MeanOverCells(
      raster, grid, atlas, threads,
      [&](int, int, std::span<const V3d> samples) {
        return FitCellUnrounded(atlas, Blend::kSrgb, samples).error;
      });
}

double CapacityOfMasks(const Image& raster, const CellGrid& grid,
                       const Atlas& atlas, int threads) {
  return MeanOverCells(
      raster, grid.size, atlas, threads,
      [&](int column, int row, std::span<const V3d> samples) {
        const int index = atlas.Find(grid.at(column, row).glyph);
        RTB_CHECK_GE(index, 0);
        const FitMask& mask =
            atlas.candidates()[static_cast<std::size_t>(index)];
        return RefitUnrounded(mask, Blend::kSrgb, samples).error;
      });
}

}  // namespace rtb
