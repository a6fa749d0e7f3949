#include "harness/live/frame_thread.h"

#include <utility>

#include "harness/live/signals.h"

namespace rtb {

FrameThread::FrameThread(std::function<void()> wake) : wake_(std::move(wake)) {
  // Signals are the main thread's: its poll must wake. Threads that this one
  // starts (TBB's) inherit that.
  const SignalsBlocked blocked;
  thread_ = std::thread([this] { Run(); });
}

FrameThread::~FrameThread() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void FrameThread::Request(const FrameRequest& request) {
  {
    const std::lock_guard lock(mutex_);
    request_ = request;
  }
  changed_.notify_all();
}

bool FrameThread::busy() const {
  const std::lock_guard lock(mutex_);
  return working_ || request_.has_value();
}

std::optional<Result<LiveFrame>> FrameThread::Take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(frame_, std::nullopt);
}

void FrameThread::Run() {
  FrameMaker maker;
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return stop_ || request_; });
    if (stop_) return;
    const FrameRequest request = *std::exchange(request_, std::nullopt);
    working_ = true;
    lock.unlock();
    auto frame = maker.Make(request);
    lock.lock();
    working_ = false;
    frame_ = std::move(frame);
    lock.unlock();
    wake_();
    lock.lock();
  }
}

}  // namespace rtb
