#include "harness/live/terminal_caps.h"

#include "core/base/error.h"
#include "core/base/numbers.h"

namespace rtb {

void TerminalCaps::Note(const ReplyEvent& reply) {
  switch (reply.kind) {
    case ReplyEvent::Kind::kAttributes:
      answered = true;
      break;
    case ReplyEvent::Kind::kSyncMode:
      sync = reply.number == 1 || reply.number == 2;  // Set or reset.
      break;
    case ReplyEvent::Kind::kKeyboard:
      key_release = true;
      break;
    case ReplyEvent::Kind::kColors:
      truecolor = reply.text.find("1:2:3") != std::string::npos ||
                  reply.text.find("1;2;3") != std::string::npos;
      break;
    case ReplyEvent::Kind::kVersion:
      version = Printable(reply.text);
      break;
    case ReplyEvent::Kind::kCellSize:
      cell_width = reply.number;
      cell_height = ParseWhole<int>(reply.text).value_or(0);
      break;
    case ReplyEvent::Kind::kStatus:
      break;
  }
}

DepthChoice ChooseDepth(const TerminalHints& hints, const TerminalCaps& caps) {
  if (hints.no_color) return {ColorDepth::kMono, "NO_COLOR"};
  if (caps.truecolor) return {ColorDepth::kTruecolor, "answered"};
  if (hints.color_term == "truecolor" || hints.color_term == "24bit") {
    return {ColorDepth::kTruecolor, "COLORTERM"};
  }
  if (hints.terminfo_colors >= 1 << 24) {
    return {ColorDepth::kTruecolor, "terminfo"};
  }
  if (hints.terminfo_colors >= 256) return {ColorDepth::k256, "terminfo"};
  if (hints.terminfo_colors >= 8) return {ColorDepth::k16, "terminfo"};
  return {ColorDepth::kMono, "terminfo"};
}

}  // namespace rtb
