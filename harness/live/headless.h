/// @file
/// The live mode without a person: the same loop into a pseudo terminal or
/// into memory, measured.
#pragma once

#include <string>

#include "core/base/result.h"
#include "harness/live/live_request.h"
#include "harness/results/live_result.h"
#include "harness/results/run_record_json.h"

namespace rtb {

/// What a run measured. Pictures follow one another as fast as they can; the
/// governor, unless its target is 0, aims at its rate all the same.
struct LiveFigures {
  double fps = 0;
  FramePercentiles frame_ms;  ///< From picture to picture.
  FramePercentiles draw_ms;   ///< All after encoding: panel to write().
  double render_ms = 0;       ///< Means.
  double encode_ms = 0;
  double bytes_per_frame = 0;
  double cells_per_frame = 0;  ///< That were sent.
  /// Whose glyph or colors are not the last frame's.
  double differing_cells_per_frame = 0;
  double cpu_ms_per_frame = 0;  ///< Of all threads.
  double rays_per_cell = 0;     ///< Eye rays really traced.
  std::string present;  ///< `direct`, `ncurses` or `string`, and into what.
  std::string encoder;
  std::string scene;
  std::string backend;
  std::string integrator;
  std::string motion;
  std::string color;
  GridSize grid;
  int frames = 0;
  int warmup = 0;
  double target_fps = 0;
};

/// Draws request.warmup + request.frames pictures.
/// @return the errors of scene, encoder and presenter.
Result<LiveFigures> RunHeadless(const LiveRequest& request);

/// `{"schema": 1, "fps", "frame_ms": {"p50", "p95", "p99"}, ...}`.
Json FiguresToJson(const LiveFigures& figures);

/// `sway`, `orbit`, `path` or `still`.
const char* NameOf(HeadlessMotion motion);

}  // namespace rtb
