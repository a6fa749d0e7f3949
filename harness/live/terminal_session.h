/// @file
/// TerminalSession: a terminal taken over, and given back as it was however
/// the program ends.
#pragma once

#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/render/sample_plan.h"
#include "harness/live/input_event.h"
#include "harness/live/terminal_caps.h"
#include "harness/live/terminfo.h"

namespace rtb {

/// What to take over, and how.
struct SessionOptions {
  int input = 0;  ///< Descriptors of one terminal.
  int output = 1;
  bool keys = true;  ///< Ask for kitty's keys where they are known.
  Terminfo terminfo;
};

/// One at a time. While it lives the terminal is raw, on its alternate screen
/// with a hidden cursor and mouse reports, and what is written to standard
/// error is held back. SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT and
/// std::terminate restore it too.
class TerminalSession {
 public:
  /// Makes the terminal raw, asks what it can do, and enters.
  /// @return kBadInput when the descriptors are no terminal.
  static Result<std::unique_ptr<TerminalSession>> Start(
      const SessionOptions& options);
  /// Gives it back.
  ~TerminalSession();
  TerminalSession(const TerminalSession&) = delete;
  TerminalSession& operator=(const TerminalSession&) = delete;

  const TerminalCaps& caps() const { return caps_; }
  /// Bytes that came in while the terminal was probed and answer nothing.
  std::string TakeEarlyInput();

  /// A descriptor of the terminal that does not block. Its own: the one that
  /// the shell shares stays as it is.
  int fd() const { return fd_; }

  /// The terminal's size now; 80 x 24 where it does not know.
  GridSize size() const;
  /// Width / height of a cell; a half where the terminal does not know.
  double cell_aspect() const;

  /// For SIGTSTP: gives the terminal back, and takes it over again.
  void Leave();
  Status Enter();

 private:
  TerminalSession() = default;
  void Probe();

  struct State;
  std::unique_ptr<State> state_;
  int fd_ = -1;
  TerminalCaps caps_;
  std::string early_;
};

}  // namespace rtb
