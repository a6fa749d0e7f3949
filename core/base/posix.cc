#include "core/base/posix.h"

#include <unistd.h>

#include <algorithm>
#include <system_error>

namespace rtb {
namespace {

constexpr std::size_t kChunk = std::size_t{1} << 18;

}  // namespace

void UniqueFd::Reset(int fd) {
  if (fd_ >= 0) ::close(fd_);
  fd_ = fd;
}

std::string ErrnoText(int code) {
  return std::error_code(code, std::generic_category()).message();
}

int ReadAll(int fd, std::size_t limit, std::string* bytes) {
  std::size_t left = limit;
  while (left > 0) {
    const std::size_t begin = bytes->size();
    const std::size_t wanted = std::min(left, kChunk);
    bytes->resize(begin + wanted);
    const ssize_t got = ::read(fd, bytes->data() + begin, wanted);
    bytes->resize(begin + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    if (got == 0) return 0;
    if (got < 0 && errno != EINTR) return errno;
    if (got > 0) left -= static_cast<std::size_t>(got);
  }
  return 0;
}

int WriteAll(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t put = ::write(fd, bytes.data(), bytes.size());
    if (put < 0 && errno != EINTR) return errno;
    if (put > 0) bytes.remove_prefix(static_cast<std::size_t>(put));
  }
  return 0;
}

}  // namespace rtb
