/// @file
/// What is drawn over and beside the picture: panel, status line, help and
/// the list of scenes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/live/live_state.h"

namespace rtb {

/// FLIP and MSE of the shown picture against the converged one.
struct LiveQuality {
  double flip = 0;
  double mse = 0;
  int passes = 0;  ///< Rays per pixel of the converged picture so far.
};

/// What was measured, as the panel shows it.
struct LiveReadings {
  double fps = 0;
  double target_fps = 0;
  double frame_p50_ms = 0;
  double frame_p99_ms = 0;
  double render_ms = 0;
  double encode_ms = 0;
  double draw_ms = 0;
  double ack_ms = 0;     ///< Until the terminal had drawn it; 0: unknown.
  std::u32string graph;  ///< One glyph a frame.
  double rays_per_second = 0;
  double rays_per_cell = 0;  ///< Eye rays really traced.
  double share = 1;          ///< Of the samples.
  int row_step = 1;
  int passes = 0;  ///< Rays accumulated in every sample.
  double bytes_per_second = 0;
  double bytes_per_frame = 0;
  double changed = 0;  ///< Share of the cells.
  double exposure = 0;
  std::string present;  ///< `direct, sync, fence`.
  std::string color_reason;
  bool recording = false;
  std::optional<LiveQuality> quality;
};

/// Lines of the panel, the log apart.
std::vector<std::u32string> PanelLines(const LiveState& state,
                                       const LiveReadings& readings);

/// Draws panel or status line, help and the list of scenes, whatever is on.
/// @param depth of the terminal: all colors are its.
void DrawOverlays(const LiveState& state, const LiveReadings& readings,
                  ColorDepth depth, CellGrid* screen);

}  // namespace rtb
