/// @file
/// What TerminalImageViewer 1.3 makes of one cell's 4 x 8 8-bit pixels.
#pragma once

#include <cstdint>
#include <span>

#include "core/base/host_device.h"
#include "core/color/srgb.h"
#include "encoders/cell.h"

namespace rtb {

inline constexpr int kTivColumns = 4;
inline constexpr int kTivRows = 8;
inline constexpr int kTivPixels = kTivColumns * kTivRows;

/// A glyph and the pixels that it sets: most significant bit = top left, row by
/// row.
struct TivGlyph {
  std::uint32_t pattern;
  char32_t code_point;
};

/// The glyphs in the program's order, which decides ties.
inline constexpr TivGlyph kTivGlyphs[] = {
#include "encoders/tiv_table.inc"
};

/// What a cell shows of which no glyph is nearer than kTivTooFar pixels.
RTB_HD constexpr TivGlyph TivDefault() { return {0x0000ffff, 0x2584}; }
inline constexpr TivGlyph kTivDefault = TivDefault();
inline constexpr int kTivTooFar = 8;

/// The cell for pixels row by row.
Cell TivCell(std::span<const Rgb8, kTivPixels> pixels);

}  // namespace rtb
