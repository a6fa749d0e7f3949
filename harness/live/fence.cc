#include "harness/live/fence.h"

#include <algorithm>
#include <limits>

namespace rtb {

void Fence::Sent(double now, int cells) {
  if (on_) sent_.push_back({now, cells});
}

void Fence::Answered(double now) {
  missed_ = 0;
  if (sent_.empty()) return;  // Of a frame that was given up.
  const Frame frame = sent_.front();
  sent_.pop_front();
  latency_ms_ = (now - frame.at) * 1e3;
  // Small frames take as long as the way there and back.
  constexpr int kEnough = 200;
  const double spent = now - std::max(frame.at, last_answer_);
  last_answer_ = now;
  if (frame.cells < kEnough || spent <= 0) return;
  const double rate = frame.cells / spent;
  constexpr double kWeight = 0.2;
  rate_ = rate_ == 0 ? rate : rate_ + kWeight * (rate - rate_);
}

bool Fence::Open(double now) {
  constexpr int kMostMissed = 3;
  if (!on_) return true;
  if (!sent_.empty() && now - sent_.front().at > kTimeout) {
    sent_.clear();
    if (++missed_ >= kMostMissed) on_ = false;
  }
  return sent_.size() < kMostOpen;
}

double Fence::Deadline() const {
  if (sent_.size() < kMostOpen) return std::numeric_limits<double>::infinity();
  return sent_.front().at + kTimeout;
}

}  // namespace rtb
