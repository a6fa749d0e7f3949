/// @file
/// The palette of 256 colors that terminals share.
#pragma once

#include "core/color/srgb.h"

namespace rtb {

/// Color `index` (0..255) as xterm defines it: 16 ANSI colors, a 6 x 6 x 6
/// cube, 24 grays. Source: xterm's defaults (XTerm-col.ad, 256colres.pl).
Rgb8 XtermColor(int index);

}  // namespace rtb
