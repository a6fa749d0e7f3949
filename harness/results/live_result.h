/// @file
/// LiveResult: what a live session took. All of it may differ between two
/// sessions, so records keep it under `ms`.
#pragma once

#include <string>

namespace rtb {

/// Percentiles of the time from frame to frame, in milliseconds.
struct FrameTimes {
  double p50 = 0;
  double p95 = 0;
  double p99 = 0;
  bool operator==(const FrameTimes&) const = default;
};

/// One session.
struct LiveResult {
  double fps = 0;
  FrameTimes frame_ms;
  double bytes_per_frame = 0;
  double cells_per_frame = 0;  ///< Cells sent, mean.
  std::string present;         ///< `direct`, `ncurses` or `string`.
  bool operator==(const LiveResult&) const = default;
};

}  // namespace rtb
