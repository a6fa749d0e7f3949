/// @file
/// Drift: slow changes of a picture, as when the camera pans over a gradient,
/// which in a single cell are less than noise.
#pragma once

#include <vector>

#include "core/math/vec.h"
#include "core/render/sample_plan.h"

namespace rtb {

/// How one cell's mean has changed since the last frame.
struct MeanChange {
  V3d change{0};        ///< In the blend space.
  double variance = 0;  ///< Of a cell's mean, per channel, from noise alone.
};

/// For each cell whether the mean of a window around it has moved by more than
/// noise explains. Windows are 5 x 5 and 9 x 9 cells, and 3 and 9 cells of
/// its row and of its column; each is a chi-square test of the three channels
/// at 1/1000, the variance counted twice for encoders that do not use all their
/// samples.
std::vector<bool> FindDrift(GridSize grid,
                            const std::vector<MeanChange>& changes);

}  // namespace rtb
