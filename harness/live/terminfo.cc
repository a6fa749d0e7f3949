#include "harness/live/terminfo.h"

#define NCURSES_NOMACROS 1
#include <ncurses.h>
// After ncurses.h, which it needs.
#include <term.h>

namespace rtb {
namespace {

/// Without padding, which no terminal of today needs: `$<50>`.
std::string StringOf(const char* name) {
  const char* value = ::tigetstr(name);
  if (value == nullptr || value == reinterpret_cast<char*>(-1)) return "";
  std::string text = value;
  for (std::size_t at; (at = text.find("$<")) != std::string::npos;) {
    const std::size_t end = text.find('>', at);
    text.erase(at, end == std::string::npos ? end : end - at + 1);
  }
  return text;
}

}  // namespace

Result<Terminfo> ReadTerminfo(const std::string& term) {
  const std::string hint =
      "set TERM to what your terminal is, e.g. xterm-256color";
  if (term.empty()) return Fail(BadInput("TERM", "is not set", hint));
  int status = 0;
  constexpr int kNoFile = -1;  // Nothing is asked of a descriptor.
  if (::setupterm(term.c_str(), kNoFile, &status) != OK) {
    return Fail(BadInput("TERM", "there is no terminal '" + term + "'", hint));
  }
  Terminfo info;
  info.name = term;
  info.colors = ::tigetnum("colors");
  info.direct = ::tigetflag("RGB") > 0 || ::tigetnum("RGB") > 0;
  info.enter = StringOf("smcup");
  info.leave = StringOf("rmcup");
  const bool moves = !StringOf("cup").empty();
  ::del_curterm(cur_term);
  if (moves) return info;
  return Fail(BadInput("TERM",
                       "the terminal '" + term + "' cannot move its cursor",
                       "use another terminal, or --headless"));
}

}  // namespace rtb
