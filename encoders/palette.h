/// @file
/// The colors that terminals share, and those that a depth leaves.
#pragma once

#include <optional>
#include <span>

#include "core/color/srgb.h"
#include "encoders/color_depth.h"

namespace rtb {

/// @name What a terminal shows where nobody set a color: xterm's color 7 on
/// black. In mono every cell shows these.
/// @{
inline constexpr Rgb8 kDefaultForeground{229, 229, 229};
inline constexpr Rgb8 kDefaultBackground{0, 0, 0};
/// @}

/// Color `index` (0..255) as xterm defines it: 16 ANSI colors, a 6 x 6 x 6
/// cube, 24 grays. Source: xterm's defaults (XTerm-col.ad, 256colres.pl).
Rgb8 XtermColor(int index);

/// The colors that cells may have at a depth, all different: with k256 those
/// of the indices 16..255 (0..15 differ between terminals), with k16 those of
/// 0..15, with kMono the default foreground and background, and none with
/// kTruecolor, which has them all.
std::span<const Rgb8> PaletteColors(ColorDepth depth);

/// The index that a terminal knows a color by: 16..255 with k256, 0..15 with
/// k16. None where it is not one of PaletteColors(depth), and with kTruecolor
/// and kMono, where colors have no index.
std::optional<int> IndexOf(Rgb8 color, ColorDepth depth);

}  // namespace rtb
