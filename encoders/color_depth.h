/// @file
/// ColorDepth: how many colors a terminal has.
#pragma once

namespace rtb {

/// What `--color` names.
enum class ColorDepth {
  kTruecolor,  ///< 24 bits.
  k256,        ///< xterm's palette of 256 colors.
  k16,         ///< The 16 ANSI colors as xterm defines them.
  kMono,       ///< Glyphs alone, in the terminal's own two colors.
};

}  // namespace rtb
