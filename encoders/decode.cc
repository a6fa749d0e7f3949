#include "encoders/decode.h"

#include <unordered_map>

#include "core/base/parallel.h"

namespace rtb {
namespace {

using Masks = std::unordered_map<char32_t, const Mask*>;

/// The masks of all glyphs in use: what can fail comes first, on one thread.
Result<Masks> CollectMasks(const CellGrid& grid, GlyphSet& glyphs) {
  Masks masks;
  for (const Cell& cell : grid.cells) {
    if (masks.contains(cell.glyph)) continue;
    RTB_ASSIGN_OR_RETURN(masks[cell.glyph], glyphs.Get(cell.glyph));
  }
  return masks;
}

void DrawCell(const Cell& cell, const Mask& mask, int left, int top,
              Image& image) {
  const Rgb fg = EncodedValues(cell.fg);
  const Rgb bg = EncodedValues(cell.bg);
  for (int y = 0; y < mask.height; ++y) {
    for (int x = 0; x < mask.width; ++x) {
      const float covered = mask.at(x, y);
      image.at(left + x, top + y) = fg * covered + bg * (1 - covered);
    }
  }
}

}  // namespace

Result<Image> Decode(const CellGrid& grid, const DecodeOptions& options) {
  const int width = options.cell_width;
  const int height = options.cell_height;
  GlyphSet glyphs(width, height, options.masks, options.font);
  RTB_ASSIGN_OR_RETURN(const Masks masks, CollectMasks(grid, glyphs));
  Image image(grid.size.columns * width, grid.size.rows * height);
  ParallelFor(grid.size.rows, 1, options.threads, [&](int begin, int end) {
    for (int row = begin; row < end; ++row) {
      for (int column = 0; column < grid.size.columns; ++column) {
        const Cell& cell = grid.at(column, row);
        DrawCell(cell, *masks.at(cell.glyph), column * width, row * height,
                 image);
      }
    }
  });
  return image;
}

}  // namespace rtb
