#include <vterm.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "encoders/palette.h"
#include "encoders/parse/glyph_text.h"
#include "encoders/parse/parse.h"
#include "encoders/parse/sgr.h"
#include "encoders/parse/terminal_input.h"

namespace rtb {
namespace {

struct FreeTerminal {
  void operator()(VTerm* terminal) const { vterm_free(terminal); }
};

// libvterm's own palette is not xterm's, so indices are looked up in ours.
Rgb8 ToRgb8(const VTermColor& color) {
  if (VTERM_COLOR_IS_DEFAULT_FG(&color)) return kDefaultForeground;
  if (VTERM_COLOR_IS_DEFAULT_BG(&color)) return kDefaultBackground;
  if (VTERM_COLOR_IS_INDEXED(&color)) return XtermColor(color.indexed.idx);
  return {color.rgb.red, color.rgb.green, color.rgb.blue};
}

/// Two thirds of each component, in 16 bits, as xterm computes it.
Rgb8 Faint(Rgb8 color) {
  const auto two_thirds = [](int component) {
    return static_cast<std::uint8_t>(component * 257 * 2 / 3 >> 8);
  };
  return {two_thirds(color.r), two_thirds(color.g), two_thirds(color.b)};
}

/// A cell never written, and the right half of a wide glyph, are spaces. Of
/// combined characters the first counts.
Cell ToCell(const VTermScreenCell& cell) {
  Cell result;
  if (IsGlyph(cell.chars[0])) result.glyph = cell.chars[0];
  result.fg = ToRgb8(cell.fg);
  result.bg = ToRgb8(cell.bg);
  if (cell.attrs.blink) result.fg = Faint(result.fg);  // See parse/sgr.h.
  if (cell.attrs.reverse) std::swap(result.fg, result.bg);
  if (cell.attrs.font == kConcealFont) result.glyph = U' ';
  return result;
}

/// Lines that left the screen at its top.
struct Scrolled {
  int lines = 0;
  bool alternate = false;  ///< Whether the alternate screen is on.
};

/// On the main screen.
int CountPushed(int, const VTermScreenCell*, void* user) {
  ++static_cast<Scrolled*>(user)->lines;
  return 1;
}

/// On the alternate screen, which keeps no history.
int CountMoved(VTermRect to, VTermRect from, void* user) {
  auto& scrolled = *static_cast<Scrolled*>(user);
  if (scrolled.alternate && to.start_row == 0) scrolled.lines += from.start_row;
  return 1;
}

int NoteProperty(VTermProp property, VTermValue* value, void* user) {
  if (property == VTERM_PROP_ALTSCREEN) {
    static_cast<Scrolled*>(user)->alternate = value->boolean != 0;
  }
  return 1;
}

CellGrid ReadScreen(VTermScreen* screen, GridSize size) {
  CellGrid grid(size);
  for (int row = 0; row < size.rows; ++row) {
    for (int column = 0; column < size.columns; ++column) {
      VTermScreenCell cell;
      vterm_screen_get_cell(screen, {row, column}, &cell);
      grid.at(column, row) = ToCell(cell);
    }
  }
  return grid;
}

/// libvterm 0.1.4 keeps four bytes of each one that it is given on the stack,
/// so it is given little at a time, up to the beginning of a sequence.
void Write(std::string_view input, VTerm* terminal) {
  constexpr std::size_t kMost = 65536;
  while (!input.empty()) {
    std::size_t count = std::min(input.size(), kMost);
    if (count < input.size()) {
      const std::size_t escape = input.rfind('\x1b', count);
      if (escape != std::string_view::npos && escape > 0) count = escape;
    }
    vterm_input_write(terminal, input.data(), count);
    input.remove_prefix(count);
  }
}

Error TooLarge(int scrolled, GridSize size) {
  return BadInput("ANSI text",
                  "does not fit into " + std::to_string(size.columns) + " x " +
                      std::to_string(size.rows) + " cells: " +
                      std::to_string(scrolled) + " lines scrolled away",
                  "name the grid that the text was made for");
}

}  // namespace

Result<CellGrid> ParseAnsi(const std::string& ansi, GridSize size) {
  if (size.columns < 1 || size.rows < 1) {
    return Fail(BadInput("grid", "a terminal has at least 1 x 1 cells"));
  }
  RTB_ASSIGN_OR_RETURN(const std::string input, TerminalInput(ansi));
  const std::unique_ptr<VTerm, FreeTerminal> terminal(
      vterm_new(size.rows, size.columns));
  if (!terminal) return Fail(Failure("ANSI text", "libvterm does not start"));
  vterm_set_utf8(terminal.get(), 1);
  VTermScreen* const screen = vterm_obtain_screen(terminal.get());
  vterm_screen_enable_altscreen(screen, 1);
  Scrolled scrolled;
  VTermScreenCallbacks callbacks{};
  callbacks.sb_pushline = CountPushed;
  callbacks.moverect = CountMoved;
  callbacks.settermprop = NoteProperty;
  vterm_screen_set_callbacks(screen, &callbacks, &scrolled);
  vterm_screen_reset(screen, 1);
  Write(input, terminal.get());
  vterm_screen_flush_damage(screen);
  if (scrolled.lines > 0) return Fail(TooLarge(scrolled.lines, size));
  return ReadScreen(screen, size);
}

}  // namespace rtb
