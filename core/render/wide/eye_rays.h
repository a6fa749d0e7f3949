/// @file
/// The eye rays of many paths at once.
#pragma once

#include <cstdint>

#include "core/math/sampling.h"
#include "core/render/camera_rays.h"
#include "core/render/sample_plan.h"
#include "core/render/wide/paths.h"

namespace rtb {

/// What the rays of one sample have in common.
struct EyeSet {
  std::uint32_t pattern = 0;  ///< EyeSample's.
  std::uint32_t count = 1;    ///< Rays of the whole sample.
  V2d position{0};            ///< The sample's in the picture, in cells.
  V2f footprint{0};           ///< Of the sample, in cells.
};

/// Rays [first, first + count) of a sample become paths at `place`: their
/// patterns, indices and places in the picture. They are stratified as
/// MultiJitter has it.
void PlaceEyes(const EyeSet& set, std::uint32_t first, int count, int place,
               Paths* paths);

/// EyeRay (camera_rays.h) for all paths.
void MakeEyeRays(const CameraRays& camera, const GridSize& grid, Paths* paths);

}  // namespace rtb
