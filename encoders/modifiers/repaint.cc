#include "encoders/modifiers/repaint.h"

#include <algorithm>
#include <functional>
#include <vector>

#include "core/base/parallel.h"
#include "encoders/fit/fit.h"
#include "encoders/fit/palette_fit.h"
#include "encoders/modifiers/dither.h"
#include "encoders/palette.h"

namespace rtb {
namespace {

constexpr int kGrain = 16;

/// Chooses a cell for the samples of its raster.
using ChooseCell = std::function<Cell(std::span<const V3d>)>;

ChooseCell ChooserOf(const Atlas& atlas, const RepaintOptions& options) {
  const Blend blend = options.blend;
  if (options.depth == ColorDepth::kTruecolor) {
    return [&atlas, blend](auto s) { return FitCell(atlas, blend, s).cell; };
  }
  if (options.depth == ColorDepth::kMono) {
    return [&atlas, blend](auto s) {
      return FitCellToColors(atlas, blend, s, kDefaultForeground,
                             kDefaultBackground)
          .cell;
    };
  }
  return [&atlas, palette = FitPalette(blend, PaletteColors(options.depth))](
             auto s) { return FitCellToPalette(atlas, palette, s).cell; };
}

/// Columns and rows of parts of a cell that are dithered by themselves: as many
/// as the glyphs can tell apart.
struct DitherTiles {
  int columns = 1;
  int rows = 1;

  explicit DitherTiles(const Atlas& atlas) {
    constexpr char32_t kDiagonal = 0x259E;
    constexpr char32_t kLowerHalf = 0x2584;
    if (atlas.width() >= 2 && atlas.Find(kDiagonal) >= 0) columns = 2;
    if (atlas.height() >= 2 && (columns == 2 || atlas.Find(kLowerHalf) >= 0)) {
      rows = 2;
    }
  }
};

/// Moves the samples of one cell by the offsets of its parts.
void AddOffsets(const RepaintOptions& options, const DitherTiles& tiles,
                int column, int row, const SampleRaster& raster,
                std::span<V3d> samples) {
  const double amplitude = DitherAmplitude(options.depth);
  for (int y = 0; y < raster.height; ++y) {
    for (int x = 0; x < raster.width; ++x) {
      const double offset =
          amplitude *
          DitherOffset(
              options.dither,
              tiles.columns * column + tiles.columns * x / raster.width,
              tiles.rows * row + tiles.rows * y / raster.height, options.seed);
      samples[static_cast<std::size_t>(y * raster.width + x)] +=
          options.blend == Blend::kOklab ? V3d(offset, 0, 0) : V3d(offset);
    }
  }
}

/// What a cell's look lacks of its samples, on the mean.
V3d Residual(const Cell& cell, const Atlas& atlas, Blend blend,
             std::span<const V3d> samples) {
  const FitMask& mask =
      atlas.candidates()[static_cast<std::size_t>(atlas.Find(cell.glyph))];
  const double covered = mask.sum / mask.size();
  std::array<V3d, 2> colors{V3d(0), V3d(0)};
  const std::array<Rgb, 2> linear = {Decode8(cell.fg), Decode8(cell.bg)};
  ToBlend(blend, linear, colors);
  V3d sum(0);
  for (const V3d& sample : samples) sum += sample;
  return sum / mask.size() - covered * colors[0] - (1 - covered) * colors[1];
}

/// Floyd and Steinberg, "An adaptive algorithm for spatial grey scale", Proc.
/// SID 17(2), 1976, over cells instead of pixels. One cell after the other.
CellGrid DiffuseErrors(SampleRaster& raster, const Atlas& atlas,
                       const RepaintOptions& options,
                       const ChooseCell& choose) {
  CellGrid grid(raster.grid);
  const auto columns = static_cast<std::size_t>(raster.grid.columns);
  // One cell more on either side; this row's and the next one's.
  std::vector<V3d> here(columns + 2, V3d(0));
  std::vector<V3d> below(columns + 2, V3d(0));
  for (int row = 0; row < raster.grid.rows; ++row) {
    for (std::size_t i = 1; i <= columns; ++i) {
      const int column = static_cast<int>(i) - 1;
      const auto samples = raster.cell(row * raster.grid.columns + column);
      for (V3d& sample : samples) sample += here[i];
      const Cell cell = choose(samples);
      grid.at(column, row) = cell;
      const V3d rest = Residual(cell, atlas, options.blend, samples);
      here[i + 1] += rest * (7.0 / 16);
      below[i - 1] += rest * (3.0 / 16);
      below[i] += rest * (5.0 / 16);
      below[i + 1] += rest * (1.0 / 16);
    }
    here.swap(below);
    std::ranges::fill(below, V3d(0));
  }
  return grid;
}

}  // namespace

CellGrid Repaint(SampleRaster raster, const Atlas& atlas,
                 const RepaintOptions& options) {
  const ChooseCell choose = ChooserOf(atlas, options);
  const bool limited = options.depth != ColorDepth::kTruecolor;
  if (limited && options.dither == Dither::kFloydSteinberg) {
    return DiffuseErrors(raster, atlas, options, choose);
  }
  CellGrid grid(raster.grid);
  const DitherTiles tiles(atlas);
  const int columns = raster.grid.columns;
  ParallelFor(raster.grid.cells(), kGrain, options.threads,
              [&](int begin, int end) {
                for (int i = begin; i < end; ++i) {
                  const auto samples = raster.cell(i);
                  if (limited && options.dither != Dither::kNone) {
                    AddOffsets(options, tiles, i % columns, i / columns, raster,
                               samples);
                  }
                  grid.cells[static_cast<std::size_t>(i)] = choose(samples);
                }
              });
  return grid;
}

bool FitsDepth(const CellGrid& grid, ColorDepth depth) {
  if (depth == ColorDepth::kTruecolor) return true;
  const auto colors = PaletteColors(depth);
  const auto known = [colors](Rgb8 color) {
    return std::ranges::find(colors, color) != colors.end();
  };
  return std::ranges::all_of(grid.cells, [&](const Cell& cell) {
    const bool fg_shows = cell.glyph != U' ' && cell.glyph != kNoBreakSpace;
    const bool bg_shows = cell.glyph != kFullBlock;
    if (depth == ColorDepth::kMono) {
      return (!fg_shows || cell.fg == kDefaultForeground) &&
             (!bg_shows || cell.bg == kDefaultBackground);
    }
    return (!fg_shows || known(cell.fg)) && (!bg_shows || known(cell.bg));
  });
}

}  // namespace rtb
