/// @file
/// Fence: keeps a terminal from falling behind. Each frame ends with a
/// question that the terminal answers when it has drawn the frame.
#pragma once

#include <deque>
#include <string_view>

namespace rtb {

/// Times in seconds. Never waits for a terminal that does not answer.
class Fence {
 public:
  /// DSR 5 (ECMA-48, section 8.3.35), which every terminal answers.
  static constexpr std::string_view kQuestion = "\x1b[5n";
  static constexpr std::size_t kMostOpen = 2;
  static constexpr double kTimeout = 0.5;

  /// @param answers whether this terminal is known to answer.
  explicit Fence(bool answers) : on_(answers) {}

  bool on() const { return on_; }

  /// A frame of that many cells was sent, with the question.
  void Sent(double now, int cells);
  /// An answer came.
  void Answered(double now);
  /// Whether another frame may be sent. Forgets frames that have waited for
  /// too long, and itself when that happens again and again.
  bool Open(double now);
  /// When Open() may change by time alone; nothing waits: infinity.
  double Deadline() const;

  bool waiting() const { return !sent_.empty(); }
  /// Milliseconds until the last answer.
  double latency_ms() const { return latency_ms_; }
  /// Cells that the terminal draws in a second, as far as is known; else 0.
  double cells_per_second() const { return rate_; }

 private:
  struct Frame {
    double at;
    int cells;
  };

  bool on_;
  std::deque<Frame> sent_;
  double last_answer_ = -1e9;
  double latency_ms_ = 0;
  double rate_ = 0;
  int missed_ = 0;  ///< Timeouts since the last answer.
};

}  // namespace rtb
