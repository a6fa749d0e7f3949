/// @file
/// TerminalCaps: what a terminal can do, as far as it tells.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "encoders/color_depth.h"
#include "harness/live/input_event.h"

namespace rtb {

/// Asked at the start, in one write: DECRQM of mode 2026, kitty's keyboard
/// flags, DECRQSS of SGR after a 24-bit color, XTVERSION, the cell's size in
/// pixels, and DA1, which every terminal answers last.
inline constexpr std::string_view kProbe =
    "\x1b[?2026$p\x1b[?u\x1b[48;2;1;2;3m\x1bP$qm\x1b\\\x1b[m\x1b[>0q\x1b[16t"
    "\x1b[c";

/// What the environment and terminfo say.
struct TerminalHints {
  std::string term;        ///< TERM.
  std::string color_term;  ///< COLORTERM.
  bool no_color = false;   ///< NO_COLOR asks for none.
  int terminfo_colors = 0;
};

/// What a terminal can do.
struct TerminalCaps {
  bool answered = false;     ///< DA1 came: answers can be relied on.
  bool sync = false;         ///< Synchronized output (mode 2026).
  bool key_release = false;  ///< kitty's keyboard protocol.
  bool truecolor = false;    ///< DECRQSS said that it keeps 24 bits.
  std::string version = {};  ///< Its name, printable; empty where unknown.
  int cell_width = 0;        ///< Pixels; 0: unknown.
  int cell_height = 0;

  /// Takes an answer to the probe into account.
  void Note(const ReplyEvent& reply);
};

/// The colors to be used where none are forced, and why.
struct DepthChoice {
  ColorDepth depth = ColorDepth::kMono;
  std::string reason;
};
DepthChoice ChooseDepth(const TerminalHints& hints, const TerminalCaps& caps);

}  // namespace rtb
