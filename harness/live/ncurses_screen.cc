#include "harness/live/ncurses_screen.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "core/base/posix.h"

#define NCURSES_NOMACROS 1
#define NCURSES_WIDECHAR 1
#include <ncurses.h>

namespace rtb {

struct NcursesScreen::State {
  std::FILE* out = nullptr;
  std::FILE* in = nullptr;
  SCREEN* screen = nullptr;
  bool clearing = false;

  ~State() {
    if (screen != nullptr) {
      ::endwin();
      ::delscreen(screen);
    }
    if (out != nullptr) std::fclose(out);
    if (in != nullptr) std::fclose(in);
  }

  /// What ncurses has written since the last time.
  std::string Take() const {
    std::fflush(out);
    const int fd = ::fileno(out);
    std::string bytes;
    ::lseek(fd, 0, SEEK_SET);
    ReadAll(fd, SIZE_MAX, &bytes);
    // An error would show as old bytes in the next frame's tests.
    if (::ftruncate(fd, 0) == 0) ::lseek(fd, 0, SEEK_SET);
    return bytes;
  }
};

Result<std::unique_ptr<NcursesScreen>> NcursesScreen::Open(
    const std::string& term, GridSize size) {
  std::unique_ptr<NcursesScreen> self(new NcursesScreen);
  self->state_ = std::make_unique<State>();
  State& state = *self->state_;
  state.out = ::fdopen(::memfd_create("ncurses", MFD_CLOEXEC), "w+");
  state.in = std::fopen("/dev/null", "r");
  if (state.out == nullptr || state.in == nullptr) {
    return Fail(Failure("ncurses", ErrnoText()));
  }
  ::use_env(FALSE);  // Neither LINES nor the size of a descriptor.
  state.screen = ::newterm(term.c_str(), state.out, state.in);
  if (state.screen == nullptr) {
    return Fail(BadInput("TERM", "there is no terminal '" + term + "'"));
  }
  ::set_term(state.screen);
  ::start_color();
  ::typeahead(-1);
  ::nonl();
  ::curs_set(0);
  ::leaveok(stdscr, TRUE);
  ::idcok(stdscr, FALSE);
  ::idlok(stdscr, FALSE);
  ::scrollok(stdscr, FALSE);
  self->Resize(size);
  self->Clear();
  ::doupdate();
  state.Take();  // The session has entered its screen itself.
  return self;
}

NcursesScreen::~NcursesScreen() = default;

int NcursesScreen::colors() const { return COLORS; }

int NcursesScreen::pairs() const { return COLOR_PAIRS - 1; }

void NcursesScreen::Resize(GridSize size) {
  ::resizeterm(size.rows, size.columns);
}

void NcursesScreen::Clear() { state_->clearing = true; }

void NcursesScreen::BeginFrame() {
  // While this flag is up, ncurses does not look through the whole screen for
  // cells of a pair that is defined anew.
  ::clearok(curscr, TRUE);
}

bool NcursesScreen::DefinePair(int pair, int fg, int bg) {
  return ::init_extended_pair(pair, fg, bg) == OK;
}

void NcursesScreen::Put(int column, int row, char32_t glyph, int pair,
                        bool bold) {
  const wchar_t text[] = {static_cast<wchar_t>(glyph), L'\0'};
  cchar_t cell;
  ::setcchar(&cell, text, bold ? A_BOLD : A_NORMAL, 0, &pair);
  ::mvwadd_wchnstr(stdscr, row, column, &cell, 1);
}

std::string NcursesScreen::TakeFrame() {
  if (!state_->clearing) ::clearok(curscr, FALSE);
  state_->clearing = false;
  ::wnoutrefresh(stdscr);
  ::doupdate();
  return state_->Take();
}

}  // namespace rtb
