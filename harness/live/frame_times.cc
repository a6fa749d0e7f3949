#include "harness/live/frame_times.h"

#include <algorithm>
#include <cmath>

namespace rtb {

double Percentile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  const auto rank = static_cast<std::size_t>(
      std::ceil(share * static_cast<double>(values.size())));
  const std::size_t index = std::clamp<std::size_t>(rank, 1, values.size()) - 1;
  std::nth_element(values.begin(),
                   values.begin() + static_cast<std::ptrdiff_t>(index),
                   values.end());
  return values[index];
}

void MovingMean::Add(double value) {
  constexpr double kWeight = 0.1;
  mean_ = any_ ? mean_ + kWeight * (value - mean_) : value;
  any_ = true;
}

void FrameTimes::Add(double now) {
  if (running_) {
    intervals_.push_back((now - last_) * 1e3);
    if (intervals_.size() > limit_) intervals_.pop_front();
  }
  last_ = now;
  running_ = true;
}

double FrameTimes::Rate() const {
  double sum = 0;
  int frames = 0;
  for (auto it = intervals_.rbegin(); it != intervals_.rend() && sum < 1000;
       ++it) {
    sum += *it;
    ++frames;
  }
  return sum > 0 ? frames * 1e3 / sum : 0;
}

std::vector<double> FrameTimes::Intervals() const {
  return {intervals_.begin(), intervals_.end()};
}

std::u32string FrameTimes::Graph(std::size_t columns, double top) const {
  std::u32string graph(columns, U' ');
  const std::size_t count = std::min(columns, intervals_.size());
  for (std::size_t i = 0; i < count; ++i) {
    const double interval = intervals_[intervals_.size() - count + i];
    const int eighths =
        std::clamp(static_cast<int>(std::lround(interval / top * 8)), 1, 8);
    graph[columns - count + i] = static_cast<char32_t>(0x2580 + eighths);
  }
  return graph;
}

}  // namespace rtb
