/// @file
/// TemporalResult: how steady an encoder draws a moving scene.
#pragma once

#include <optional>

namespace rtb {

/// The measures of docs/measures.md, section "Moving scenes".
struct TemporalResult {
  int frames = 0;
  double fps = 0;     ///< Frames of one second of the scene's time.
  double tde = 0;     ///< Mean temporal difference error.
  double t_flip = 0;  ///< Mean difference of the FLIP maps of steps.
  /// Error along the renderer's motion minus the reference's own; none where
  /// no pixel can be followed.
  std::optional<double> warp_error;
  double churn = 0;               ///< Share of cells that change a frame.
  double static_flicker = 0;      ///< The same between two seeds.
  double static_flicker_rms = 0;  ///< RMS of the change of encoded values.
  double bytes_per_frame = 0;     ///< Mean size of a frame's ANSI text.
  bool operator==(const TemporalResult&) const = default;
};

}  // namespace rtb
