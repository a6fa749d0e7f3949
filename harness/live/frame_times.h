/// @file
/// FrameTimes: the last frames' times, their percentiles and their graph.
#pragma once

#include <deque>
#include <string>
#include <vector>

namespace rtb {

/// The smallest value that `share` of the values do not exceed (the nearest
/// rank); 0 for none. @param share in (0, 1].
double Percentile(std::vector<double> values, double share);

/// A value averaged over the last second or so.
class MovingMean {
 public:
  void Add(double value);
  double mean() const { return mean_; }

 private:
  double mean_ = 0;
  bool any_ = false;
};

/// When frames were shown.
class FrameTimes {
 public:
  /// @param limit frames that are remembered.
  explicit FrameTimes(std::size_t limit) : limit_(limit) {}

  /// A frame was shown, at that many seconds.
  void Add(double now);
  /// The next frame's time does not count: nothing was to be shown meanwhile.
  void Pause() { running_ = false; }

  /// Frames per second of the last second that frames were shown in.
  double Rate() const;
  /// Milliseconds from frame to frame, the oldest first.
  std::vector<double> Intervals() const;
  /// The latest intervals as blocks of eighths, `columns` of them; a full one
  /// is `top` milliseconds.
  std::u32string Graph(std::size_t columns, double top) const;

 private:
  std::size_t limit_;
  std::deque<double> intervals_;
  double last_ = 0;
  bool running_ = false;
};

}  // namespace rtb
