/// @file
/// OutputQueue: bytes on their way to a terminal that may be slow.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace rtb {

/// Never blocks, where the descriptor is non-blocking.
class OutputQueue {
 public:
  /// Writes to a descriptor, which stays the caller's.
  explicit OutputQueue(int fd) : fd_(fd) {}
  /// Hands everything over to `sink` at once.
  explicit OutputQueue(std::function<void(std::string_view)> sink)
      : sink_(std::move(sink)) {}

  /// Appends bytes and writes what goes.
  Status Push(std::string_view bytes);
  /// Writes what goes. @return kFailure when nobody reads any more.
  Status Flush();

  bool empty() const { return waiting_.empty(); }
  /// For poll(); -1 with a sink.
  int fd() const { return fd_; }
  /// Bytes pushed so far.
  std::uint64_t pushed() const { return pushed_; }

 private:
  int fd_ = -1;
  std::function<void(std::string_view)> sink_;
  std::string waiting_;
  std::uint64_t pushed_ = 0;
};

}  // namespace rtb
