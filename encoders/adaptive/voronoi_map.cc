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

}  // namespace

VoronoiMap::VoronoiMap(GridSize grid, double cell_aspect, Priority priority)
    : grid_(grid),
      priority_(priority),
      cell_width_(CellWidth(cell_aspect)),
      pitch_x_(cell_width_ / kSlotColumns),
      pitch_y_(kCellHeight / kSlotRows),
      stride_(static_cast<std::size_t>(grid.columns * kSlotColumns + 2) +
              kSlotRoom),
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

SlotRows VoronoiMap::RowsFrom(int left, int top, int columns, int rows) {
  const std::size_t at = Index(left, top);
  return {stride_,        columns,        rows,          &distance2_[at],
          &color_[0][at], &color_[1][at], &color_[2][at]};
}

void VoronoiMap::Enter(const SeenSample& sample, const V2f& at,
                       const Window& window) {
  EnterSample(
      {at, V2f(pitch_x_, pitch_y_), sample.encoded, window.left, window.top},
      RowsFrom(window.left, window.top, window.right - window.left + 1,
               window.bottom - window.top + 1));
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
  const int left = begin * kSlotColumns;
  const int top = row * kSlotRows;
  const int count = (end - begin) * kSlotColumns;
  std::vector<float> best(static_cast<std::size_t>(count) + kSlotRoom);
  const std::size_t first = Index(left, top);
  CompareSlots(RowsFrom(left, top, count, kSlotRows), kLeastContrast,
               priority_ == Priority::kRoot,
               {&extent_[first], &contrast_[first], best.data()});
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
