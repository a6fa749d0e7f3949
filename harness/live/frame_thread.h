/// @file
/// FrameThread: makes pictures apart from input and drawing.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "harness/live/frame_maker.h"

namespace rtb {

/// A thread with a FrameMaker. The latest request wins, and so does the
/// latest picture.
class FrameThread {
 public:
  /// @param wake called by the thread when a picture is there.
  explicit FrameThread(std::function<void()> wake);
  /// Waits for the picture that is in work.
  ~FrameThread();
  FrameThread(const FrameThread&) = delete;
  FrameThread& operator=(const FrameThread&) = delete;

  /// Asks for a picture, in place of a request that has not been begun.
  void Request(const FrameRequest& request);

  /// Whether a request waits or is in work.
  bool busy() const;

  /// The newest picture that has not been taken, or why there is none.
  std::optional<Result<LiveFrame>> Take();

 private:
  void Run();

  std::function<void()> wake_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<FrameRequest> request_;
  std::optional<Result<LiveFrame>> frame_;
  bool working_ = false;
  bool stop_ = false;
  std::thread thread_;
};

}  // namespace rtb
