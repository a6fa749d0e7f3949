/// @file
/// The least error that any encoder of a glyph set can have, and a run's
/// distance from it: METRICS, "Bound", in docs/measures.md.
#pragma once

#include <filesystem>
#include <optional>
#include <span>

#include "harness/measure/error_input.h"
#include "harness/results/bound.h"

namespace rtb {

/// The least MSE of two unrounded colors a cell over the glyphs.
/// @param reference sRGB-encoded values, the decoded cell size times the grid.
/// @param glyphs rising code points, at least one.
/// @param cache where the figure is kept, under a name that hashes reference,
///   glyphs, grid and masks; empty: nowhere.
/// @return the errors of masks that cannot be made, and of the cache.
Result<double> GlyphBound(const Image& reference, GridSize grid,
                          std::span<const char32_t> glyphs,
                          const DecodeOptions& decode,
                          const std::filesystem::path& cache);

/// A run against the bound of its glyphs. None where the reference is smaller
/// than the decoded grid: reduced to it, cells no longer show two colors.
/// @return a Failure when the run is below its bound, which only an error of
/// the measurement can bring about.
Result<std::optional<BoundResult>> CompareWithBound(const ErrorInput& input);

/// The comparison itself. @param spec names the run in the Failure.
Result<BoundResult> CompareWithBound(const std::string& spec, double mse,
                                     const std::string& glyphs, double bound);

}  // namespace rtb
