/// @file
/// NcursesScreen: a screen of ncurses whose output stays in memory. The only
/// file beside terminfo.cc that knows ncurses is ncurses_screen.cc.
#pragma once

#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/render/sample_plan.h"

namespace rtb {

/// One at a time. Everything that ncurses writes goes into a file in memory,
/// so that a frame is one piece of bytes and nothing touches the terminal's
/// modes.
class NcursesScreen {
 public:
  /// @return kBadInput for an unknown terminal.
  static Result<std::unique_ptr<NcursesScreen>> Open(const std::string& term,
                                                     GridSize size);
  ~NcursesScreen();
  NcursesScreen(const NcursesScreen&) = delete;
  NcursesScreen& operator=(const NcursesScreen&) = delete;

  int colors() const;
  /// Color pairs beside pair 0.
  int pairs() const;

  void Resize(GridSize size);
  /// The terminal's content is unknown: the next frame draws it all.
  void Clear();
  /// Between BeginFrame and TakeFrame pairs are defined and cells put.
  void BeginFrame();
  /// Defines a pair that no cell on the screen shows. @return false when
  /// ncurses refuses.
  bool DefinePair(int pair, int fg, int bg);
  /// Puts one glyph, of one column.
  void Put(int column, int row, char32_t glyph, int pair, bool bold);
  /// The frame's bytes.
  std::string TakeFrame();

 private:
  NcursesScreen() = default;
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace rtb
