/// @file
/// LiveResult: what a live session took. All of it may differ between two
/// sessions, so records keep it under `ms`.
#pragma once

#include <string>

namespace rtb {

/// Milliseconds that the given shares of frames do not exceed.
struct FramePercentiles {
  double p50 = 0;
  double p95 = 0;
  double p99 = 0;
  bool operator==(const FramePercentiles&) const = default;
};

/// One session.
struct LiveResult {
  double fps = 0;
  FramePercentiles frame_ms;
  double bytes_per_frame = 0;
  double cells_per_frame = 0;  ///< Cells sent, mean.
  std::string present;         ///< `direct`, `ncurses` or `string`.
  bool operator==(const LiveResult&) const = default;
};

}  // namespace rtb
