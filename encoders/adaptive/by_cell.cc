#include "encoders/adaptive/by_cell.h"

#include <algorithm>

namespace rtb {
namespace {

/// Samples farther than this from a cell do not count in it.
constexpr float kMargin = kCellHeight / 2;

}  // namespace

ByCell::ByCell(const SeenSamples& samples, double cell_aspect)
    : grid_(samples.grid()), cell_width_(CellWidth(cell_aspect)) {
  begin_.resize(static_cast<std::size_t>(grid_.cells()) + 1);
  for (int c = 0; c < grid_.cells(); ++c) {
    const auto at = static_cast<std::size_t>(c);
    begin_[at + 1] = begin_[at] + static_cast<std::size_t>(samples.count(c));
  }
  sorted_.resize(begin_.back());
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (const SeenSample& sample : samples.all()) {
    sorted_[next[static_cast<std::size_t>(sample.cell)]++] = &sample;
  }
}

void ByCell::Gather(int cell, NearSamples& near) const {
  near.Clear();
  const int column = cell % grid_.columns;
  const int row = cell / grid_.columns;
  for (int j = std::max(0, row - 1); j <= std::min(grid_.rows - 1, row + 1);
       ++j) {
    for (int i = std::max(0, column - 1);
         i <= std::min(grid_.columns - 1, column + 1); ++i) {
      AddOf(j * grid_.columns + i, static_cast<float>(i - column),
            static_cast<float>(j - row), near);
    }
  }
}

/// @param left, top of that cell, in cells.
void ByCell::AddOf(int cell, float left, float top, NearSamples& near) const {
  const auto c = static_cast<std::size_t>(cell);
  for (std::size_t s = begin_[c]; s < begin_[c + 1]; ++s) {
    const SeenSample& sample = *sorted_[s];
    const float x = (left + sample.position.x) * cell_width_;
    const float y = (top + sample.position.y) * kCellHeight;
    const float ox = std::max({-x, x - cell_width_, 0.0f});
    const float oy = std::max({-y, y - kCellHeight, 0.0f});
    if (ox * ox + oy * oy > kMargin * kMargin) continue;
    if (near.size() == kMostNear) return;
    near.Add({x, y}, sample.encoded, sample.linear);
  }
}

}  // namespace rtb
