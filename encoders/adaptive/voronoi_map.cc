#include "encoders/adaptive/voronoi_map.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <utility>

#include "core/base/parallel.h"

namespace rtb {
namespace {

/// Rows of cells that a thread takes at once. Samples of the rows beside them
/// are looked at too.
constexpr int kGrain = 4;

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
    : priority_(priority),
      cell_width_(CellWidth(cell_aspect)),
      best_gains_(static_cast<std::size_t>(grid.cells())) {
  slots_.grid = grid;
  slots_.pitch = V2f(cell_width_ / kSlotColumns, kCellHeight / kSlotRows);
  const std::size_t count = slots_.room() * kSlots;
  fields_ = hwy::AllocateAligned<float>(6 * count);
  float* next = fields_.get();
  for (float** field : {&slots_.distance2, &slots_.extent, &slots_.r, &slots_.g,
                        &slots_.b, &slots_.contrast}) {
    *field = std::exchange(next, next + count);
  }
  std::fill_n(slots_.distance2, count, kFar2);
  std::fill_n(slots_.extent, count, kEmptySlot);
  std::fill_n(slots_.r, 4 * count, 0.0f);
  changed_.resize(slots_.room());
  slots_.changed = changed_.data();
}

void VoronoiMap::Insert(std::span<const SeenSample> samples,
                        std::span<const float> reaches, int threads) {
  std::ranges::fill(changed_, 0);
  const GridSize grid = slots_.grid;
  ParallelFor(grid.rows, kGrain, threads, [&](int begin, int end) {
    InsertIntoRows(begin, end - 1, samples, reaches);
  });
  RepeatBorder();
  ParallelFor(grid.rows, kGrain, threads, [&](int begin, int end) {
    for (int row = begin; row < end; ++row) {
      CompareSlots(slots_, row, kLeastContrast, priority_ == Priority::kRoot,
                   &best_gains_[static_cast<std::size_t>(row * grid.columns)]);
    }
  });
}

/// Rows of cells take what they need from the samples of those beside them, so
/// that some can be worked on at once.
void VoronoiMap::InsertIntoRows(int first, int last,
                                std::span<const SeenSample> samples,
                                std::span<const float> reaches) {
  const auto [begin, end] =
      OfRows(samples, slots_.grid.columns, first - 1, last + 1);
  EnterSamples(samples.subspan(begin, end - begin),
               reaches.subspan(begin, end - begin), first, last, slots_);
}

void VoronoiMap::RepeatBorder() {
  const auto [columns, rows] = slots_.grid;
  constexpr int kLast = kSlots - kSlotColumns;  // The last row of a cell.
  for (float* const channel : {slots_.r, slots_.g, slots_.b}) {
    const auto cell = [&](int x, int y) {
      return channel + slots_.At(x, y) * kSlots;
    };
    for (int y = 0; y < rows; ++y) {
      for (int i = 0; i < kSlots; i += kSlotColumns) {
        cell(-1, y)[i + kSlotColumns - 1] = cell(0, y)[i];
        cell(columns, y)[i] = cell(columns - 1, y)[i + kSlotColumns - 1];
      }
    }
    for (int x = 0; x < columns; ++x) {
      std::copy_n(cell(x, 0), kSlotColumns, cell(x, -1) + kLast);
      std::copy_n(cell(x, rows - 1) + kLast, kSlotColumns, cell(x, rows));
    }
  }
}

CellChoice VoronoiMap::ChoiceIn(int cell) const {
  const auto from =
      slots_.At(cell % slots_.grid.columns, cell / slots_.grid.columns) *
      kSlots;
  CellChoice choice;
  choice.contrast = slots_.contrast + from;
  choice.distance2 = slots_.distance2 + from;
  choice.extent = slots_.extent + from;
  choice.cell_width = cell_width_;
  choice.cell = cell;
  return choice;
}

void VoronoiMap::Prefetch(int cell) const {
  constexpr int kLine = 64 / sizeof(float);
  const CellChoice choice = ChoiceIn(cell);
  for (int i = 0; i < kSlots; i += kLine) {
    hwy::Prefetch(choice.contrast + i);
    hwy::Prefetch(choice.distance2 + i);
    hwy::Prefetch(choice.extent + i);
  }
}

CellSlots VoronoiMap::Slots(int cell) const {
  const CellChoice from = ChoiceIn(cell);
  CellSlots slots;
  std::copy_n(from.contrast, kSlots, slots.contrast.begin());
  std::copy_n(from.distance2, kSlots, slots.distance2.begin());
  std::copy_n(from.extent, kSlots, slots.extent.begin());
  return slots;
}

}  // namespace rtb
