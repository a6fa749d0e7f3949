#include "harness/live/drained_pty.h"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "harness/live/fence.h"
#include "harness/live/signals.h"

namespace rtb {
namespace {

/// How often the question ends past the first `known` bytes of a text.
int CountNew(const std::string& text, std::size_t known) {
  int count = 0;
  const std::size_t length = Fence::kQuestion.size();
  std::size_t at = known >= length ? known - length + 1 : 0;
  while ((at = text.find(Fence::kQuestion, at)) != std::string::npos) {
    ++count;
    at += length;
  }
  return count;
}

}  // namespace

Result<std::unique_ptr<DrainedPty>> DrainedPty::Open(GridSize size) {
  std::unique_ptr<DrainedPty> pty(new DrainedPty);
  pty->master_.Reset(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC));
  char name[256];
  const int master = pty->master_.get();
  if (master < 0 || ::grantpt(master) != 0 || ::unlockpt(master) != 0 ||
      ::ptsname_r(master, name, sizeof name) != 0) {
    return Fail(Failure("pseudo terminal", ErrnoText()));
  }
  pty->terminal_.Reset(
      ::open(name, O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  if (!pty->terminal_.valid()) return Fail(Failure(name, ErrnoText()));
  struct termios modes {};
  ::tcgetattr(pty->fd(), &modes);
  ::cfmakeraw(&modes);
  ::tcsetattr(pty->fd(), TCSANOW, &modes);
  winsize window{};
  window.ws_col = static_cast<unsigned short>(size.columns);
  window.ws_row = static_cast<unsigned short>(size.rows);
  ::ioctl(master, TIOCSWINSZ, &window);
  const SignalsBlocked blocked;
  pty->thread_ = std::thread([self = pty.get()] { self->Drain(); });
  return pty;
}

DrainedPty::~DrainedPty() {
  terminal_.Reset();  // Reads of the other side fail from now on.
  if (thread_.joinable()) thread_.join();
}

void DrainedPty::Drain() {
  constexpr std::string_view kAnswer = "\x1b[0n";
  std::string bytes(65536, '\0');
  std::string seen;  // The end of what came before, and what comes now.
  while (true) {
    const ssize_t count = ::read(master_.get(), bytes.data(), bytes.size());
    if (count <= 0) return;
    const std::size_t known = seen.size();
    seen.append(bytes, 0, static_cast<std::size_t>(count));
    for (int n = CountNew(seen, known); n > 0; --n) {
      if (WriteAll(master_.get(), kAnswer) != 0) return;
    }
    const std::size_t keep =
        std::min<std::size_t>(seen.size(), Fence::kQuestion.size() - 1);
    seen.erase(0, seen.size() - keep);
  }
}

}  // namespace rtb
