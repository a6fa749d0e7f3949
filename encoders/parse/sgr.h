/// @file
/// SGR, the sequence that sets colors and attributes, in the form that
/// libvterm 0.1 reads right.
#pragma once

#include <string>
#include <string_view>

namespace rtb {

/// @name How attributes that libvterm 0.1 does not know reach its cells: in
/// the place of attributes that a cell does not show.
/// @{
inline constexpr int kConcealFont = 9;   ///< SGR 8 as SGR 19.
inline constexpr int kFaintAsBlink = 5;  ///< SGR 2 as SGR 5.
/// @}

/// What `CSI parameters m` does to the look of cells, as sequences of few
/// parameters each. libvterm 0.1.4 crashes on more than 16, reads the (empty)
/// color space of `38:2:SPACE:r:g:b` as red, and takes the color of underlines
/// (58) for attributes. Left out: what cells do not show (bold, italic, lines,
/// blinking, fonts) and colors out of range.
/// Source: ITU-T T.416, section 13.1.8; xterm's ctlseqs.
std::string PortableSgr(std::string_view parameters);

}  // namespace rtb
