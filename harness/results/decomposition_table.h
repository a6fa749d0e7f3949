/// @file
/// The table of where runs' errors come from.
#pragma once

#include <span>
#include <string>

#include "harness/results/run_record.h"

namespace rtb {

/// A row for each run that has a decomposition: its MSE in percent by step
/// (rendering, sampling, encoding, and what these have in common), what a font
/// adds, the encoder's own error in percent of itself, the FLIP of the same
/// encoder on the reference, and the gap to the glyphs' bound. Empty where no
/// run has one.
std::string FormatDecompositionTable(std::span<const RunResult* const> runs);

}  // namespace rtb
