#include "harness/live/signals.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>

#include "core/base/check.h"

namespace rtb {
namespace {

constexpr int kSignals = 65;
// What a handler may touch: one flag for each signal, and the pipe's end.
std::atomic<bool> noted[kSignals];
std::atomic<int> wake_fd{-1};

void Note(int signal) {
  const int saved = errno;
  noted[signal] = true;
  const char byte = 0;
  const int fd = wake_fd;
  // A full pipe wakes as well.
  if (fd >= 0 && ::write(fd, &byte, 1) < 0) errno = saved;
  errno = saved;
}

struct sigaction Noting() {
  struct sigaction action {};
  action.sa_handler = Note;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  return action;
}

}  // namespace

SignalsBlocked::SignalsBlocked() {
  sigset_t all;
  sigfillset(&all);
  // Crashes stay with the thread that caused them.
  for (const int crash : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) {
    sigdelset(&all, crash);
  }
  pthread_sigmask(SIG_BLOCK, &all, &before_);
}

SignalsBlocked::~SignalsBlocked() {
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

WakePipe::WakePipe() {
  int ends[2];
  RTB_CHECK_EQ(::pipe2(ends, O_CLOEXEC | O_NONBLOCK), 0);
  read_.Reset(ends[0]);
  write_.Reset(ends[1]);
}

void WakePipe::Wake() const {
  const char byte = 0;
  // A full pipe wakes as well.
  if (::write(write_.get(), &byte, 1) < 0) return;
}

void WakePipe::Clear() const {
  char bytes[64];
  while (::read(read_.get(), bytes, sizeof bytes) > 0) {
  }
}

SignalCatcher::SignalCatcher(const WakePipe& pipe) {
  for (std::atomic<bool>& flag : noted) flag = false;
  wake_fd = pipe.write_fd();
  const struct sigaction action = Noting();
  for (std::size_t i = 0; i < kCaught.size(); ++i) {
    sigaction(kCaught[i], &action, &before_[i]);
  }
}

SignalCatcher::~SignalCatcher() {
  wake_fd = -1;
  for (std::size_t i = 0; i < kCaught.size(); ++i) {
    sigaction(kCaught[i], &before_[i], nullptr);
  }
}

std::optional<int> SignalCatcher::Take() {
  for (const int signal : kCaught) {
    if (noted[signal].exchange(false)) return signal;
  }
  return std::nullopt;
}

void SignalCatcher::Stop() {
  struct sigaction by_default {};
  by_default.sa_handler = SIG_DFL;
  sigaction(SIGTSTP, &by_default, nullptr);
  ::raise(SIGTSTP);  // Returns after SIGCONT.
  const struct sigaction action = Noting();
  sigaction(SIGTSTP, &action, nullptr);
}

}  // namespace rtb
