#include "encoders/modifiers/drift.h"

#include <algorithm>

#include "core/base/check.h"

namespace rtb {
namespace {

constexpr int kReach = 2;
/// The 99.9 % quantile of chi-square with 3 degrees of freedom.
constexpr double kLimit = 16.27;
/// Both frames are noisy, and an encoder may leave half of its samples out.
constexpr double kVariances = 4;

}  // namespace

std::vector<bool> FindDrift(GridSize grid,
                            const std::vector<MeanChange>& changes) {
  RTB_CHECK_EQ(changes.size(), static_cast<std::size_t>(grid.cells()));
  std::vector<bool> drifted(changes.size());
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      V3d change(0);
      double variance = 0;
      for (int y = std::max(0, row - kReach);
           y <= std::min(grid.rows - 1, row + kReach); ++y) {
        for (int x = std::max(0, column - kReach);
             x <= std::min(grid.columns - 1, column + kReach); ++x) {
          const MeanChange& cell =
              changes[static_cast<std::size_t>(y * grid.columns + x)];
          change += cell.change;
          variance += kVariances * cell.variance;
        }
      }
      drifted[static_cast<std::size_t>(row * grid.columns + column)] =
          change.length2() > kLimit * variance;
    }
  }
  return drifted;
}

}  // namespace rtb
