#include "encoders/adaptive/voronoi_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/parallel.h"

namespace rtb {
namespace {

/// Before there is a sample. Finite, as is its square.
constexpr float kFar2 = 1e9f;

/// Added to every squared contrast: rays that nothing visible asks for go
/// where samples are farthest. A quarter of an 8-bit code, squared.
constexpr float kLeastContrast = 1e-6f;

/// The samples of the cells of rows `first` to `last`, as indices.
std::pair<std::size_t, std::size_t> OfRows(std::span<const SeenSample> samples,
                                           int columns, int first, int last) {
  const auto at = [&](int row) {
    const auto found =
        std::ranges::lower_bound(samples, row * columns, {}, &SeenSample::cell);
    return static_cast<std::size_t>(found - samples.begin());
  };
  return {at(first), at(last + 1)};
}

/// Squared distances of colors in a row of slots.
struct ColorRow {
  const float* r;
  const float* g;
  const float* b;

  float Apart(std::ptrdiff_t i, std::ptrdiff_t j) const {
    const float dr = r[i] - r[j];
    const float dg = g[i] - g[j];
    const float db = b[i] - b[j];
    return dr * dr + dg * dg + db * db;
  }
};

}  // namespace

VoronoiMap::VoronoiMap(GridSize grid, double cell_aspect, Priority priority)
    : grid_(grid),
      priority_(priority),
      cell_width_(CellWidth(cell_aspect)),
      pitch_x_(cell_width_ / kSlotColumns),
      pitch_y_(kCellHeight / kSlotRows),
      stride_(static_cast<std::size_t>(grid.columns * kSlotColumns + 2)),
      best_gains_(static_cast<std::size_t>(grid.cells())),
      changed_(best_gains_.size()) {
  const std::size_t slots =
      stride_ * static_cast<std::size_t>(grid.rows * kSlotRows + 2);
  distance2_.resize(slots, kFar2);
  extent_.resize(slots, kEmptySlot);
  contrast_.resize(slots);
  for (std::vector<float>& channel : color_) channel.resize(slots);
}

void VoronoiMap::Insert(std::span<const SeenSample> samples,
                        std::span<const float> reaches, int threads) {
  ParallelFor(grid_.rows, 1, threads, [&](int begin, int end) {
    for (int row = begin; row < end; ++row) {
      InsertIntoRow(row, samples, reaches);
    }
  });
  RepeatBorder();
  ParallelFor(grid_.rows, 1, threads, [&](int begin, int end) {
    for (int row = begin; row < end; ++row) CompareRow(row);
  });
}

/// Each row of cells takes what it needs from the samples of three, so that
/// rows can be worked on at once.
void VoronoiMap::InsertIntoRow(int row, std::span<const SeenSample> samples,
                               std::span<const float> reaches) {
  std::fill_n(changed_.begin() + row * grid_.columns, grid_.columns, 0);
  const auto [begin, end] = OfRows(samples, grid_.columns, row - 1, row + 1);
  for (std::size_t i = begin; i < end; ++i) {
    const SeenSample& sample = samples[i];
    const int column = sample.cell % grid_.columns;
    const int sample_row = sample.cell / grid_.columns;
    const V2f at =
        (V2f(static_cast<float>(column), static_cast<float>(sample_row)) +
         sample.position) *
        V2f(kSlotColumns, kSlotRows);
    const int x = static_cast<int>(at.x);
    const int y = static_cast<int>(at.y);
    const int across = static_cast<int>(std::ceil(reaches[i] / pitch_x_));
    const int down = static_cast<int>(std::ceil(reaches[i] / pitch_y_));
    const Window window = {
        std::max(0, x - across), std::max(row * kSlotRows, y - down),
        std::min(grid_.columns * kSlotColumns - 1, x + across),
        std::min((row + 1) * kSlotRows - 1, y + down)};
    if (window.top > window.bottom) continue;
    const int last = window.right / kSlotColumns;
    for (int c = window.left / kSlotColumns; c <= last; ++c) {
      changed_[static_cast<std::size_t>(row * grid_.columns + c)] = 1;
    }
    Enter(sample, at, window);
    if (sample_row != row) continue;
    float& extent = extent_[Index(x, y)];
    extent = WithOneMore(extent);
  }
}

void VoronoiMap::Enter(const SeenSample& sample, const V2f& at,
                       const Window& window) {
  const Rgb color = sample.encoded;
  const int count = window.right - window.left + 1;
  const float first = static_cast<float>(window.left) + 0.5f - at.x;
  for (int y = window.top; y <= window.bottom; ++y) {
    const float dy = (static_cast<float>(y) + 0.5f - at.y) * pitch_y_;
    const std::size_t row = Index(window.left, y);
    float* const d = &distance2_[row];
    float* const r = &color_[0][row];
    float* const g = &color_[1][row];
    float* const b = &color_[2][row];
    for (int i = 0; i < count; ++i) {
      const float dx = (first + static_cast<float>(i)) * pitch_x_;
      const float distance2 = dx * dx + dy * dy;
      const bool nearer = distance2 < d[i];
      d[i] = nearer ? distance2 : d[i];
      r[i] = nearer ? color.x : r[i];
      g[i] = nearer ? color.y : g[i];
      b[i] = nearer ? color.z : b[i];
    }
  }
}

void VoronoiMap::RepeatBorder() {
  const int width = grid_.columns * kSlotColumns;
  const int height = grid_.rows * kSlotRows;
  for (std::vector<float>& channel : color_) {
    for (int y = 0; y < height; ++y) {
      channel[Index(-1, y)] = channel[Index(0, y)];
      channel[Index(width, y)] = channel[Index(width - 1, y)];
    }
    const auto row = [&](int y) {
      return channel.begin() + static_cast<std::ptrdiff_t>(Index(-1, y));
    };
    std::copy_n(row(0), stride_, row(-1));
    std::copy_n(row(height - 1), stride_, row(height));
  }
}

bool VoronoiMap::ChangedAround(int cell) const {
  const int x = cell % grid_.columns;
  const int y = cell / grid_.columns;
  const auto at = static_cast<std::size_t>(cell);
  const auto columns = static_cast<std::size_t>(grid_.columns);
  return changed_[at] || (x > 0 && changed_[at - 1]) ||
         (x + 1 < grid_.columns && changed_[at + 1]) ||
         (y > 0 && changed_[at - columns]) ||
         (y + 1 < grid_.rows && changed_[at + columns]);
}

void VoronoiMap::CompareRow(int row) {
  const int first = row * grid_.columns;
  for (int begin = 0; begin < grid_.columns; ++begin) {
    if (!ChangedAround(first + begin)) continue;
    int end = begin + 1;
    while (end < grid_.columns && ChangedAround(first + end)) ++end;
    Compare(row, begin, end);
    begin = end;
  }
}

void VoronoiMap::Compare(int row, int begin, int end) {
  const auto stride = static_cast<std::ptrdiff_t>(stride_);
  const auto count = static_cast<std::size_t>((end - begin) * kSlotColumns);
  std::vector<float> best(count);
  for (int y = row * kSlotRows; y < (row + 1) * kSlotRows; ++y) {
    const std::size_t at = Index(begin * kSlotColumns, y);
    const ColorRow color = {&color_[0][at], &color_[1][at], &color_[2][at]};
    float* const contrast = &contrast_[at];
    for (std::size_t k = 0; k < count; ++k) {
      const auto i = static_cast<std::ptrdiff_t>(k);
      contrast[k] = std::max(color.Apart(i - 1, i + 1),
                             color.Apart(i - stride, i + stride)) +
                    kLeastContrast;
    }
    if (priority_ == Priority::kRoot) {
      for (std::size_t k = 0; k < count; ++k) {
        contrast[k] = std::sqrt(contrast[k]);
      }
    }
    const float* const distance2 = &distance2_[at];
    const float* const extent = &extent_[at];
    for (std::size_t k = 0; k < count; ++k) {
      best[k] = std::max(best[k], Gain(contrast[k], distance2[k], extent[k]));
    }
  }
  for (int cell = begin; cell < end; ++cell) {
    const auto at = static_cast<std::size_t>((cell - begin) * kSlotColumns);
    best_gains_[static_cast<std::size_t>(row * grid_.columns + cell)] =
        std::ranges::max(std::span(best).subspan(at, kSlotColumns));
  }
}

CellSlots VoronoiMap::Slots(int cell) const {
  CellSlots slots;
  const int left = cell % grid_.columns * kSlotColumns;
  const int top = cell / grid_.columns * kSlotRows;
  for (int y = 0; y < kSlotRows; ++y) {
    const auto to = static_cast<std::size_t>(y * kSlotColumns);
    const std::size_t from = Index(left, top + y);
    for (std::size_t i = 0; i < kSlotColumns; ++i) {
      slots.contrast[to + i] = contrast_[from + i];
      slots.distance2[to + i] = distance2_[from + i];
      slots.extent[to + i] = extent_[from + i];
    }
  }
  return slots;
}

}  // namespace rtb
