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

/// `truecolor`, `256`, `16` or `mono`.
constexpr const char* NameOf(ColorDepth depth) {
  switch (depth) {
    case ColorDepth::k256:
      return "256";
    case ColorDepth::k16:
      return "16";
    case ColorDepth::kMono:
      return "mono";
    case ColorDepth::kTruecolor:
      break;
  }
  return "truecolor";
}

}  // namespace rtb
