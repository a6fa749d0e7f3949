/// @file
/// Restore: the last resort that gives a terminal back when the program
/// crashes.
#pragma once

#include <termios.h>

#include <string_view>

namespace rtb {

/// What it takes to give a terminal back; a crash handler may use it.
struct RestorePlan {
  int fd = -1;
  struct termios modes {};
  std::string_view bytes;  ///< Must outlive the plan's arming.
  int saved_stderr = -1;   ///< The real standard error; -1: not held back.
  int held_stderr = -1;    ///< File of what was written meanwhile.
};

/// Installs handlers of SIGSEGV, SIGBUS, SIGFPE, SIGILL and SIGABRT, on a
/// stack of their own, and of std::terminate. They restore and go on to die
/// as they would have.
void ArmRestore(const RestorePlan& plan);

/// Takes them away.
void DisarmRestore();

/// Restores now, by async-signal-safe calls alone; the first call of a plan
/// does it, further ones nothing.
void RestoreNow();

}  // namespace rtb
