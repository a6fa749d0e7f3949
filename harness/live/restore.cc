#include "harness/live/restore.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <exception>

namespace rtb {
namespace {

constexpr std::array<int, 5> kCrashes = {SIGSEGV, SIGBUS, SIGFPE, SIGILL,
                                         SIGABRT};
constexpr std::size_t kStackBytes = 64 * 1024;

RestorePlan plan;
std::atomic<bool> armed{false};
std::array<struct sigaction, kCrashes.size()> before;
std::terminate_handler before_terminate = nullptr;
alignas(16) std::array<std::byte, kStackBytes> crash_stack;
stack_t stack_before;

/// Everything, although the descriptor may be non-blocking and slow.
void WriteFully(int fd, const char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t written = ::write(fd, bytes, count);
    if (written >= 0) {
      bytes += written;
      count -= static_cast<std::size_t>(written);
    } else if (errno == EAGAIN) {
      ::usleep(1000);
    } else if (errno != EINTR) {
      return;
    }
  }
}

/// What was written to standard error meanwhile goes where it belongs.
void ReleaseStandardError() {
  if (plan.saved_stderr < 0) return;
  ::dup2(plan.saved_stderr, STDERR_FILENO);
  ::lseek(plan.held_stderr, 0, SEEK_SET);
  char bytes[512];
  for (ssize_t count;
       (count = ::read(plan.held_stderr, bytes, sizeof bytes)) > 0;) {
    WriteFully(STDERR_FILENO, bytes, static_cast<std::size_t>(count));
  }
}

void OnCrash(int signal) {
  RestoreNow();
  ::raise(signal);  // SA_RESETHAND: now it does what it would have done.
}

[[noreturn]] void OnTerminate() {
  RestoreNow();
  if (before_terminate != nullptr) before_terminate();
  ::abort();
}

}  // namespace

void ArmRestore(const RestorePlan& new_plan) {
  plan = new_plan;
  armed = true;
  stack_t alternate{};
  alternate.ss_sp = crash_stack.data();
  alternate.ss_size = crash_stack.size();
  ::sigaltstack(&alternate, &stack_before);
  struct sigaction action {};
  action.sa_handler = OnCrash;
  action.sa_flags = static_cast<int>(SA_ONSTACK | SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  for (std::size_t i = 0; i < kCrashes.size(); ++i) {
    ::sigaction(kCrashes[i], &action, &before[i]);
  }
  before_terminate = std::set_terminate(OnTerminate);
}

void DisarmRestore() {
  armed = false;
  for (std::size_t i = 0; i < kCrashes.size(); ++i) {
    ::sigaction(kCrashes[i], &before[i], nullptr);
  }
  std::set_terminate(before_terminate);
  ::sigaltstack(&stack_before, nullptr);
}

void RestoreNow() {
  if (!armed.exchange(false)) return;
  WriteFully(plan.fd, plan.bytes.data(), plan.bytes.size());
  ::tcsetattr(plan.fd, TCSANOW, &plan.modes);
  ReleaseStandardError();
}

}  // namespace rtb
