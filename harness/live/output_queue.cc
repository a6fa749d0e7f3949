#include "harness/live/output_queue.h"

#include <unistd.h>

#include <cerrno>

#include "core/base/posix.h"

namespace rtb {

Status OutputQueue::Push(std::string_view bytes) {
  pushed_ += bytes.size();
  if (sink_) {
    sink_(bytes);
    return {};
  }
  waiting_ += bytes;
  return Flush();
}

Status OutputQueue::Flush() {
  std::size_t done = 0;
  while (done < waiting_.size()) {
    const ssize_t count =
        ::write(fd_, waiting_.data() + done, waiting_.size() - done);
    if (count >= 0) {
      done += static_cast<std::size_t>(count);
    } else if (errno == EAGAIN) {
      break;
    } else if (errno != EINTR) {
      return Fail(Failure("terminal", ErrnoText()));
    }
  }
  waiting_.erase(0, done);
  return {};
}

}  // namespace rtb
