#include "core/base/process.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <sstream>
#include <thread>

#include "core/base/check.h"
#include "core/base/spawn.h"

namespace rtb {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

/// When to give up, if ever.
class Deadline {
 public:
  explicit Deadline(double seconds) : seconds_(seconds) {}

  bool Set() const { return seconds_ > 0; }
  bool Past() const { return Set() && Left() <= 0; }
  /// For poll(2): rounded up, and at most a minute at a time.
  int Milliseconds() const {
    if (!Set()) return -1;
    return static_cast<int>(std::ceil(std::clamp(Left(), 0.0, 60.0) * 1000));
  }

 private:
  double Left() const {
    return seconds_ - Seconds(Clock::now() - start_).count();
  }

  double seconds_;
  Clock::time_point start_ = Clock::now();
};

/// Takes what a pipe holds now; closes it at its end.
void Drain(UniqueFd* pipe, std::string* text) {
  std::array<char, 1 << 16> buffer;
  const ssize_t got = ::read(pipe->get(), buffer.data(), buffer.size());
  if (got > 0) {
    text->append(buffer.data(), static_cast<std::size_t>(got));
  } else if (got == 0 || errno != EINTR) {
    pipe->Reset();
  }
}

/// Both pipes at once: a child that fills one while we wait for the other
/// would never end.
/// @return whether both ended in time.
bool Collect(Child* child, const Deadline& deadline, ProcessResult* result) {
  while (child->out().valid() || child->err().valid()) {
    if (deadline.Past()) return false;
    // poll(2) skips negative descriptors.
    std::array<pollfd, 2> pipes{pollfd{child->out().get(), POLLIN, 0},
                                pollfd{child->err().get(), POLLIN, 0}};
    if (::poll(pipes.data(), pipes.size(), deadline.Milliseconds()) <= 0) {
      continue;
    }
    if (pipes[0].revents != 0) Drain(&child->out(), &result->out);
    if (pipes[1].revents != 0) Drain(&child->err(), &result->err);
  }
  return true;
}

/// A child may close its output long before it ends.
/// @return whether it ended in time.
bool Await(Child* child, const Deadline& deadline) {
  if (!deadline.Set()) return child->Ended(true);
  while (!child->Ended(false)) {
    if (deadline.Past()) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

}  // namespace

Result<ProcessResult> RunProcess(const ProcessOptions& options) {
  RTB_CHECK(!options.argv.empty());
  const std::string& name = options.argv.front();
  const auto program = FindProgram(name);
  if (!program) {
    return Fail(Missing(name, "no such program was found",
                        "install it, or put its folder on PATH"));
  }
  const Deadline deadline(options.timeout_seconds);
  RTB_ASSIGN_OR_RETURN(Child child,
                       Child::Start(*program, options.argv, options.directory,
                                    options.environment));
  ProcessResult result;
  if (!Collect(&child, deadline, &result) || !Await(&child, deadline)) {
    std::ostringstream what;
    what << "did not end within " << options.timeout_seconds << " s";
    return Fail(Failure(name, what.str()));
  }
  result.exit_status = child.ExitStatus();
  return result;
}

}  // namespace rtb
