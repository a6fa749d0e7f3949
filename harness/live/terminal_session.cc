#include "harness/live/terminal_session.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>

#include "core/base/posix.h"
#include "harness/arguments.h"
#include "harness/live/input_parser.h"
#include "harness/live/restore.h"

namespace rtb {
namespace {

// Drag and press reports in SGR form; no wrapping at the last column.
constexpr std::string_view kEnter =
    "\x1b[?25l\x1b[?7l\x1b[?1002h\x1b[?1006h\x1b[m\x1b[2J";
// CAN first, which cuts a sequence that was half written.
constexpr std::string_view kLeave =
    "\x18\x1b[?2026l\x1b[?1006l\x1b[?1003l\x1b[?1002l";
constexpr std::string_view kLast = "\x1b[?7h\x1b[m\x1b[?25h";
// kitty: escape codes, event types, alternate keys, all keys as escapes.
constexpr std::string_view kKeysOn = "\x1b[>15u";
constexpr std::string_view kKeysOff = "\x1b[<u";

double Now() {
  return std::chrono::duration<double>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

/// A description of the terminal that nobody shares, so that it may be
/// non-blocking. Where it cannot be opened anew (after `su`, say), the shared
/// one, as it is: reads do not wait in raw mode anyway.
UniqueFd OwnDescriptor(int shared) {
  constexpr int kFlags = O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC;
  char name[256];
  UniqueFd own;
  if (::ttyname_r(shared, name, sizeof name) == 0) {
    own.Reset(::open(name, kFlags));
  }
  if (!own.valid()) own.Reset(::open("/dev/tty", kFlags));
  if (!own.valid()) own.Reset(::fcntl(shared, F_DUPFD_CLOEXEC, 3));
  return own;
}

struct termios Raw(struct termios modes) {
  ::cfmakeraw(&modes);
  modes.c_cc[VMIN] = 0;
  modes.c_cc[VTIME] = 0;
  return modes;
}

}  // namespace

struct TerminalSession::State {
  SessionOptions options;
  UniqueFd tty;
  struct termios before {};
  std::string enter;
  std::string leave;
  UniqueFd saved_stderr;
  UniqueFd held_stderr;
  bool entered = false;
};

Result<std::unique_ptr<TerminalSession>> TerminalSession::Start(
    const SessionOptions& options) {
  if (::isatty(options.input) == 0 || ::isatty(options.output) == 0) {
    return Fail(BadInput("live", "standard input and output are no terminal",
                         "run it in a terminal, or with --headless"));
  }
  std::unique_ptr<TerminalSession> session(new TerminalSession);
  session->state_ = std::make_unique<State>();
  State& state = *session->state_;
  state.options = options;
  state.tty = OwnDescriptor(options.output);
  if (!state.tty.valid()) return Fail(Failure("live", ErrnoText()));
  session->fd_ = state.tty.get();
  if (::tcgetattr(session->fd_, &state.before) != 0) {
    return Fail(Failure("live", ErrnoText()));
  }
  state.entered = true;  // From here on there is something to give back.
  const struct termios raw = Raw(state.before);
  ::tcsetattr(session->fd_, TCSANOW, &raw);
  session->Probe();
  const bool keys = options.keys && session->caps_.key_release;
  session->caps_.key_release = keys;
  const Terminfo& info = options.terminfo;
  const bool alternate = !info.enter.empty() && !info.leave.empty();
  state.enter = (alternate ? info.enter : "\x1b[?1049h") +
                std::string(keys ? kKeysOn : "") + std::string(kEnter);
  state.leave = std::string(kLeave) + std::string(keys ? kKeysOff : "") +
                std::string(kLast) + (alternate ? info.leave : "\x1b[?1049l");
  RTB_RETURN_IF_ERROR(session->Enter());
  return session;
}

TerminalSession::~TerminalSession() { Leave(); }

void TerminalSession::Probe() {
  constexpr double kPatience = 0.2;
  constexpr double kEscapeTime = 0.025;
  if (::write(fd_, kProbe.data(), kProbe.size()) < 0) return;
  const double deadline = Now() + kPatience;
  InputParser parser;
  while (!caps_.answered) {
    const double left = deadline - Now();
    if (left <= 0) break;
    pollfd ready{fd_, POLLIN, 0};
    ::poll(&ready, 1, static_cast<int>(std::max(left, kEscapeTime) * 1e3));
    char bytes[1024];
    const ssize_t count = ::read(fd_, bytes, sizeof bytes);
    if (count <= 0) continue;
    const std::string_view text(bytes, static_cast<std::size_t>(count));
    bool reply = false;
    for (const InputEvent& event : parser.Feed(text)) {
      if (const auto* answer = std::get_if<ReplyEvent>(&event)) {
        caps_.Note(*answer);
        reply = true;
      }
    }
    // What was typed meanwhile is not lost.
    if (!reply && !parser.pending()) early_ += text;
  }
}

std::string TerminalSession::TakeEarlyInput() {
  return std::exchange(early_, {});
}

Status TerminalSession::Enter() {
  State& state = *state_;
  const struct termios raw = Raw(state.before);
  if (::tcsetattr(fd_, TCSANOW, &raw) != 0) {
    return Fail(Failure("live", ErrnoText()));
  }
  state.entered = true;
  if (::isatty(STDERR_FILENO) != 0) {
    state.saved_stderr.Reset(::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3));
    state.held_stderr.Reset(::memfd_create("stderr", MFD_CLOEXEC));
    ::dup2(state.held_stderr.get(), STDERR_FILENO);
  }
  ArmRestore({fd_, state.before, state.leave, state.saved_stderr.get(),
              state.held_stderr.get()});
  const int error = WriteAll(fd_, state.enter);
  if (error != 0 && error != EAGAIN) {
    return Fail(Failure("terminal", ErrnoText(error)));
  }
  return {};
}

void TerminalSession::Leave() {
  State& state = *state_;
  if (!std::exchange(state.entered, false)) return;
  if (state.leave.empty()) {  // Never entered: it was made raw alone.
    ::tcsetattr(fd_, TCSANOW, &state.before);
    return;
  }
  // Answers that are still to come would be typed into the shell.
  ::tcflush(fd_, TCIFLUSH);
  RestoreNow();
  DisarmRestore();
  state.saved_stderr.Reset();
  state.held_stderr.Reset();
}

GridSize TerminalSession::size() const {
  winsize size{};
  ::ioctl(fd_, TIOCGWINSZ, &size);
  if (size.ws_col == 0 || size.ws_row == 0) return {80, 24};
  return {std::min<int>(size.ws_col, kMaxGridSide),
          std::min<int>(size.ws_row, kMaxGridSide)};
}

double TerminalSession::cell_aspect() const {
  winsize size{};
  ::ioctl(fd_, TIOCGWINSZ, &size);
  const auto ratio = [](double width, double height) {
    const double aspect = height > 0 ? width / height : 0;
    return aspect >= 0.2 && aspect <= 2 ? aspect : 0;
  };
  const double columns = std::max<double>(size.ws_col, 1);
  const double rows = std::max<double>(size.ws_row, 1);
  const double pixels = ratio(size.ws_xpixel / columns, size.ws_ypixel / rows);
  if (pixels > 0) return pixels;
  const double probed = ratio(caps_.cell_width, caps_.cell_height);
  return probed > 0 ? probed : 0.5;
}

}  // namespace rtb
