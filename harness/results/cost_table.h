/// @file
/// The table of what runs took beside their times.
#pragma once

#include <span>
#include <string>

#include "harness/results/run_record.h"

namespace rtb {

/// Rays traced per second of rendering, by its median time; none where either
/// is unknown.
std::optional<double> RaysPerSecond(const RunResult& run);

/// A row for each run that knows its rays: these by kind, millions of rays per
/// second, and bytes of a frame; then a line with the times of loading the
/// scene and building its accelerator. Empty where no run knows its rays.
std::string FormatCostTable(std::span<const RunResult* const> runs);

}  // namespace rtb
