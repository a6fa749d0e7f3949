/// @file
/// Cell: what one character position of a terminal shows.
#pragma once

#include "core/color/srgb.h"

namespace rtb {

/// @name Glyphs that show one color alone.
/// @{
inline constexpr char32_t kNoBreakSpace = 0x00A0;
inline constexpr char32_t kFullBlock = 0x2588;
/// @}

/// A glyph in two display colors. A space shows its background alone, a full
/// block its foreground alone.
struct Cell {
  char32_t glyph = U' ';
  Rgb8 fg;  ///< Foreground.
  Rgb8 bg;  ///< Background.
  bool operator==(const Cell&) const = default;
};

/// The canonical form in which grids are compared: U+00A0 becomes a space; a
/// space's foreground and a full block's background, which nobody sees, become
/// black.
Cell Canonical(Cell cell);

}  // namespace rtb
