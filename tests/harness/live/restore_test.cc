#include "harness/live/restore.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

#include <csignal>
#include <stdexcept>
#include <string>
#include <thread>

#include "core/base/posix.h"

namespace rtb {
namespace {

constexpr std::string_view kBytes = "given back";

/// A pseudo terminal whose modes a child of the test changes and gives back.
class RestoreDeathTest : public testing::Test {
 protected:
  RestoreDeathTest() {
    master_.Reset(::posix_openpt(O_RDWR | O_NOCTTY));
    ::grantpt(master_.get());
    ::unlockpt(master_.get());
    char name[256];
    ::ptsname_r(master_.get(), name, sizeof name);
    terminal_.Reset(::open(name, O_RDWR | O_NOCTTY));
    ::tcgetattr(terminal_.get(), &before_);
  }

  /// To be called in the child.
  void TakeOver() {
    struct termios raw = before_;
    ::cfmakeraw(&raw);
    ::tcsetattr(terminal_.get(), TCSANOW, &raw);
    ArmRestore({.fd = terminal_.get(), .modes = before_, .bytes = kBytes});
  }

  void ExpectGivenBack() {
    struct termios now {};
    ::tcgetattr(terminal_.get(), &now);
    EXPECT_EQ(now.c_lflag, before_.c_lflag);
    EXPECT_EQ(now.c_oflag, before_.c_oflag);
    char bytes[64] = {};
    EXPECT_EQ(::read(master_.get(), bytes, sizeof bytes),
              static_cast<ssize_t>(kBytes.size()));
    EXPECT_EQ(bytes, kBytes);
  }

  UniqueFd master_;
  UniqueFd terminal_;
  struct termios before_ {};
};

TEST_F(RestoreDeathTest, AnExceptionThatNobodyCatches) {
  EXPECT_EXIT(
      {
        TakeOver();
        std::terminate();
      },
      testing::KilledBySignal(SIGABRT), "");
  ExpectGivenBack();
}

TEST_F(RestoreDeathTest, AnExceptionInAThread) {
  EXPECT_EXIT(
      {
        TakeOver();
        std::thread([] { throw std::runtime_error("nobody catches"); }).join();
      },
      testing::KilledBySignal(SIGABRT), "nobody catches");
  ExpectGivenBack();
}

TEST_F(RestoreDeathTest, Crashes) {
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) {
    EXPECT_EXIT(
        {
          TakeOver();
          ::raise(signal);
        },
        testing::KilledBySignal(signal), "");
    ExpectGivenBack();
  }
}

TEST_F(RestoreDeathTest, HeldBackErrorsComeAfterwards) {
  EXPECT_EXIT(
      {
        const int saved = ::dup(STDERR_FILENO);
        const int held = ::memfd_create("held", 0);
        ::dup2(held, STDERR_FILENO);
        ArmRestore({.fd = terminal_.get(),
                    .modes = before_,
                    .bytes = kBytes,
                    .saved_stderr = saved,
                    .held_stderr = held});
        WriteAll(STDERR_FILENO, "last words");
        std::abort();
      },
      testing::KilledBySignal(SIGABRT), "last words");
}

TEST_F(RestoreDeathTest, DisarmedNothingHappens) {
  EXPECT_EXIT(
      {
        TakeOver();
        DisarmRestore();
        std::abort();
      },
      testing::KilledBySignal(SIGABRT), "");
  ::fcntl(master_.get(), F_SETFL, O_NONBLOCK);
  char bytes[64];
  EXPECT_LT(::read(master_.get(), bytes, sizeof bytes), 1);
}

}  // namespace
}  // namespace rtb
