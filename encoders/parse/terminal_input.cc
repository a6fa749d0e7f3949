#include "encoders/parse/terminal_input.h"

namespace rtb {
namespace {

/// Length of the sequence at the front that changes no cell and moves no
/// cursor: LF, CR, or CSI ... m, h or l. 0 when something else stands there.
std::size_t InvisibleLength(std::string_view text) {
  if (text[0] == '\n' || text[0] == '\r') return 1;
  if (!text.starts_with("\x1b[")) return 0;
  const std::size_t end = text.find_first_not_of("0123456789;:?", 2);
  if (end == std::string_view::npos) return 0;
  const char final = text[end];
  return final == 'm' || final == 'h' || final == 'l' ? end + 1 : 0;
}

/// Where the invisible rest of the text begins.
std::size_t EndOfVisible(std::string_view text) {
  std::size_t end = 0;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t skipped = InvisibleLength(text.substr(i));
    i += skipped > 0 ? skipped : 1;
    if (skipped == 0) end = i;
  }
  return end;
}

}  // namespace

std::string TerminalInput(std::string_view output) {
  const std::size_t visible = EndOfVisible(output);
  std::string input;
  for (std::size_t i = 0; i < output.size(); ++i) {
    if (output[i] == '\n' && i >= visible) continue;
    if (output[i] == '\n') input += '\r';
    input += output[i];
  }
  return input;
}

}  // namespace rtb
