/// @file
/// The table that the main job prints.
#pragma once

#include <span>
#include <string>

#include "harness/results/run_record.h"

namespace rtb {

/// A comparison whose times vary more than this is printed with a warning.
inline constexpr double kMaxVariation = 0.10;

/// One table for each scene, grid and raster among the runs, in order of
/// appearance, under a caption that states these and FLIP's pixels per degree:
/// encoder, rays per cell, times of rendering and encoding in ms as
/// `median [95 % interval]`, frames per second, MSE, PSNR, SSIM, FLIP. What is
/// undefined is `-`. Below it, a line for each stage whose coefficient of
/// variation exceeds kMaxVariation, then the tables of cost_table.h and
/// decomposition_table.h.
std::string FormatRunTable(std::span<const RunResult> runs);

}  // namespace rtb
