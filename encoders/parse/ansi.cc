#include <vterm.h>

#include <memory>
#include <string>
#include <utility>

#include "encoders/palette.h"
#include "encoders/parse/glyph_text.h"
#include "encoders/parse/parse.h"
#include "encoders/parse/terminal_input.h"

namespace rtb {
namespace {

/// xterm's color 7 on black: what a cell shows whose color nobody set.
constexpr Rgb8 kDefaultForeground{229, 229, 229};
constexpr Rgb8 kDefaultBackground{0, 0, 0};

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

/// A cell never written, and the right half of a wide glyph, are spaces.
Cell ToCell(const VTermScreenCell& cell) {
  Cell result;
  if (IsGlyph(cell.chars[0])) result.glyph = cell.chars[0];
  result.fg = ToRgb8(cell.fg);
  result.bg = ToRgb8(cell.bg);
  if (cell.attrs.reverse) std::swap(result.fg, result.bg);
  return result;
}

/// Counts the lines that leave the screen at its top.
int CountScrolled(int, const VTermScreenCell*, void* user) {
  ++*static_cast<int*>(user);
  return 1;
}

}  // namespace

Result<CellGrid> ParseAnsi(const std::string& ansi, GridSize size) {
  if (size.columns < 1 || size.rows < 1) {
    return Fail(BadInput("grid", "a terminal has at least 1 x 1 cells"));
  }
  const std::unique_ptr<VTerm, FreeTerminal> terminal(
      vterm_new(size.rows, size.columns));
  if (!terminal) return Fail(Failure("ANSI text", "libvterm does not start"));
  vterm_set_utf8(terminal.get(), 1);
  VTermScreen* const screen = vterm_obtain_screen(terminal.get());
  vterm_screen_enable_altscreen(screen, 1);
  int scrolled = 0;
  VTermScreenCallbacks callbacks{};
  callbacks.sb_pushline = CountScrolled;
  vterm_screen_set_callbacks(screen, &callbacks, &scrolled);
  vterm_screen_reset(screen, 1);
  const std::string input = TerminalInput(ansi);
  vterm_input_write(terminal.get(), input.data(), input.size());
  vterm_screen_flush_damage(screen);
  if (scrolled > 0) {
    return Fail(BadInput("ANSI text",
                         "does not fit into " + std::to_string(size.columns) +
                             " x " + std::to_string(size.rows) + " cells: " +
                             std::to_string(scrolled) + " lines scrolled away",
                         "name the grid that the text was made for"));
  }
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

}  // namespace rtb
