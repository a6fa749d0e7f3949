/// @file
/// LiveView: everything that a live picture depends on.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "core/scene/animation.h"
#include "encoders/color_depth.h"
#include "harness/arguments.h"

namespace rtb {

/// What is to be seen, and how it is drawn.
struct LiveView {
  std::string scene;  ///< Name or file.
  std::string backend = "embree";
  std::string integrator = "whitted";
  /// SPECs: the whole picture's, or those of a split screen's two sides.
  std::array<std::string, 2> encoders;
  bool split = false;
  int divider = 0;  ///< Columns of the left side, where the screen is split.
  GridSize grid;
  double cell_aspect = 0.5;
  ColorDepth depth = ColorDepth::kTruecolor;
  int spp = 1;
  int max_depth = -1;
  double time = 0;
  std::optional<CameraFrame> camera;  ///< In place of the scene's.
  std::optional<double> exposure;     ///< Stops; none: the scene's.
  std::uint64_t seed = 0;
  int threads = 0;
  bool temporal = true;  ///< Cells stay while noise explains the difference.
};

/// How many rays a frame may take.
struct RayBudget {
  int spp = 1;       ///< Rays per sample.
  double share = 1;  ///< Of the samples, in (0, 1].
  int row_step = 1;  ///< Every how many rows are drawn.
  bool operator==(const RayBudget&) const = default;
};

/// Whether the samples of one view hold for the other: all but encoders and
/// colors are the same.
bool SameSamples(const LiveView& a, const LiveView& b);

/// Whether two views are the same picture.
bool SamePicture(const LiveView& a, const LiveView& b);

}  // namespace rtb
