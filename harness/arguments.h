/// @file
/// Arguments as text to values: grids and sizes with their limits (numbers are
/// core/base/numbers.h).
/// Every error says what was found and what is expected.
#pragma once

#include <cstdint>
#include <string>

#include "core/base/numbers.h"
#include "core/base/result.h"
#include "core/render/sample_plan.h"
#include "harness/pixel_size.h"

namespace rtb {

/// @name Limits that keep a typing error from filling the memory.
/// @{
inline constexpr int kMaxGridSide = 4096;  ///< Columns or rows.
inline constexpr int kMaxImageSide = 65536;
inline constexpr int kMaxCellSide = 256;  ///< Pixels of one cell.
inline constexpr std::int64_t kMaxSamples = std::int64_t{1} << 28;
inline constexpr std::int64_t kMaxRasterPixels = std::int64_t{1} << 26;
/// @}

/// `COLSxROWS`, each 1..kMaxGridSide.
Result<GridSize> ParseGrid(const std::string& place, const std::string& text);

/// `WIDTHxHEIGHT` of an image, each 1..kMaxImageSide, kMaxSamples in all.
Result<PixelSize> ParseImageSize(const std::string& place,
                                 const std::string& text);

/// `WIDTHxHEIGHT` of one cell, each 1..kMaxCellSide.
Result<PixelSize> ParseCellSize(const std::string& place,
                                const std::string& text);

/// Success when a plan asks for no more than kMaxSamples.
Status CheckSampleCount(const std::string& place, const SamplePlan& plan);

/// The raster of a grid, if it stays under kMaxRasterPixels.
Result<PixelSize> RasterSize(GridSize grid, PixelSize cell);

}  // namespace rtb
