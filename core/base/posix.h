/// @file
/// What every caller of POSIX needs: an owned descriptor, errno as text, and
/// reads and writes that finish what they began.
#pragma once

#include <cerrno>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace rtb {

/// Owns a file descriptor and closes it.
class UniqueFd {
 public:
  UniqueFd() = default;
  explicit UniqueFd(int fd) : fd_(fd) {}
  UniqueFd(UniqueFd&& other) noexcept : fd_(other.Release()) {}
  UniqueFd& operator=(UniqueFd&& other) noexcept {
    Reset(other.Release());
    return *this;
  }
  ~UniqueFd() { Reset(); }

  bool valid() const { return fd_ >= 0; }
  int get() const { return fd_; }
  /// Gives the descriptor away, unclosed.
  int Release() { return std::exchange(fd_, -1); }
  /// Closes the descriptor and owns another.
  void Reset(int fd = -1);

 private:
  int fd_ = -1;
};

/// The text of an errno value, by default the current one.
std::string ErrnoText(int code = errno);

/// Appends at most `limit` bytes to `bytes`, up to the end of the file.
/// @return 0, or the errno of the read that failed.
int ReadAll(int fd, std::size_t limit, std::string* bytes);

/// Writes all bytes, however many calls it takes.
/// @return 0, or the errno of the write that failed.
int WriteAll(int fd, std::string_view bytes);

}  // namespace rtb
