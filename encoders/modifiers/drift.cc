#include "encoders/modifiers/drift.h"

#include <algorithm>
#include <array>

#include "core/base/check.h"

namespace rtb {
namespace {

/// Cells around one, as far as they reach to each side.
struct Window {
  int across;
  int down;
};

/// A gradient that pans moves all of a square, in which noise averages out; an
/// edge moves a line of cells, which a square dilutes.
constexpr std::array<Window, 6> kWindows = {
    {{2, 2}, {4, 4}, {1, 0}, {0, 1}, {4, 0}, {0, 4}}};

/// The 99.9 % quantile of chi-square with 3 degrees of freedom.
constexpr double kLimit = 16.27;
/// Both frames are noisy, and an encoder may leave half of its samples out.
constexpr double kVariances = 4;

/// Whether the mean of the window around a cell has moved.
bool Drifted(GridSize grid, const std::vector<MeanChange>& changes, int cell,
             const Window& window) {
  const int column = cell % grid.columns;
  const int row = cell / grid.columns;
  V3d change(0);
  double variance = 0;
  for (int y = std::max(0, row - window.down);
       y <= std::min(grid.rows - 1, row + window.down); ++y) {
    for (int x = std::max(0, column - window.across);
         x <= std::min(grid.columns - 1, column + window.across); ++x) {
      const MeanChange& at =
          changes[static_cast<std::size_t>(y * grid.columns + x)];
      change += at.change;
      variance += kVariances * at.variance;
    }
  }
  return change.length2() > kLimit * variance;
}

}  // namespace

std::vector<bool> FindDrift(GridSize grid,
                            const std::vector<MeanChange>& changes) {
  RTB_CHECK_EQ(changes.size(), static_cast<std::size_t>(grid.cells()));
  std::vector<bool> drifted(changes.size());
  for (int cell = 0; cell < grid.cells(); ++cell) {
    drifted[static_cast<std::size_t>(cell)] =
        std::ranges::any_of(kWindows, [&](const Window& window) {
          return Drifted(grid, changes, cell, window);
        });
  }
  return drifted;
}

}  // namespace rtb
