/// @file
/// What stands between a program's output and libvterm: the terminal driver,
/// and what libvterm 0.1 would misread.
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"

namespace rtb {

/// `output` as libvterm should get it.
///
/// - LF becomes CR LF, as a tty writes it.
/// - What follows the last byte that draws is left out, line ends above all: a
///   picture as high as the terminal would otherwise scroll its first row
///   away. So is leaving the alternate screen there: a full-screen program's
///   picture is the one that it showed last. Reversing the screen stays.
/// - SGR becomes PortableSgr; REP (`CSI n b`) becomes the characters, because
///   libvterm 0.1.4 hangs where there is nothing to repeat.
/// - Titles, device control and other strings, sequences that break off and
///   parameters that no terminal could mean are left out.
///
/// @return kBadInput for graphics (sixel, kitty's, iTerm2's): they are pixels,
///   and no cells.
Result<std::string> TerminalInput(std::string_view output);

}  // namespace rtb
