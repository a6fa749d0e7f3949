/// @file
/// Signals as data: handlers note them and wake a poll; the loop acts.
#pragma once

#include <signal.h>

#include <array>
#include <optional>

#include "core/base/posix.h"

namespace rtb {

/// Blocks all signals that a program may catch in the calling thread, for
/// threads that are started meanwhile.
class SignalsBlocked {
 public:
  SignalsBlocked();
  ~SignalsBlocked();
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;

 private:
  sigset_t before_;
};

/// A pipe to oneself: any thread and any signal handler may wake a poll.
class WakePipe {
 public:
  WakePipe();
  /// Becomes readable when somebody called Wake since the last Clear.
  int fd() const { return read_.get(); }
  int write_fd() const { return write_.get(); }
  void Wake() const;
  void Clear() const;

 private:
  UniqueFd read_;
  UniqueFd write_;
};

/// Catches SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGTSTP, SIGCONT and SIGWINCH
/// while it lives, and puts the handlers that were there back. One at a time.
class SignalCatcher {
 public:
  /// @param pipe is woken by every signal; must outlive this.
  explicit SignalCatcher(const WakePipe& pipe);
  ~SignalCatcher();
  SignalCatcher(const SignalCatcher&) = delete;
  SignalCatcher& operator=(const SignalCatcher&) = delete;

  /// A signal that has come and was not taken yet: those that end the program
  /// first.
  std::optional<int> Take();

  /// Stops the program by SIGTSTP as the shell expects it; returns when it
  /// goes on.
  void Stop();

 private:
  static constexpr std::array<int, 7> kCaught = {
      SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGTSTP, SIGCONT, SIGWINCH};

  std::array<struct sigaction, kCaught.size()> before_;
};

}  // namespace rtb
