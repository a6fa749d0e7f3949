#include "encoders/adaptive/voronoi_map.h"

#include <algorithm>
#include <utility>

#include "core/base/parallel.h"

namespace rtb {
namespace {

/// Rows of cells that a thread takes at once. Samples of the rows beside them
/// are looked at too.
constexpr int kGrain = 8;

/// Added to every squared contrast: rays that nothing visible asks for go
/// where samples are farthest. A quarter of an 8-bit code, squared.
constexpr float kLeastContrast = 1e-6f;

/// Slots without samples.
CellSlots Empty() {
  CellSlots slots{};
  slots.distance2.fill(kFar2);
  return slots;
}

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
  slots_.cell_width = cell_width_;
  cells_ = hwy::AllocateAligned<CellSlots>(slots_.room());
  slots_.cells = cells_.get();
  changed_.resize(slots_.room());
  slots_.changed = changed_.data();
  farthest_.resize(slots_.room() * kBlocks);
  slots_.farthest = farthest_.data();
  around_.resize(farthest_.size());
  slots_.around = around_.data();
  gains_.resize(farthest_.size());
  slots_.gains = gains_.data();
  places_.reserve(best_gains_.size());
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      places_.push_back(static_cast<std::uint32_t>(slots_.At(column, row)));
    }
  }
}

void VoronoiMap::Clear() {
  std::fill_n(slots_.cells, slots_.room(), Empty());
  for (int row = 0; row < slots_.grid.rows; ++row) {
    std::fill_n(slots_.farthest + slots_.At(0, row) * kBlocks,
                slots_.grid.columns * kBlocks, kFar2);
  }
  std::ranges::fill(around_, kFar2);
  std::ranges::fill(changed_, ~std::uint32_t{0});
}

void VoronoiMap::Start(std::span<const SeenSample> samples,
                       std::span<const V2f> positions, int threads) {
  const Lattice lattice(positions, cell_width_);
  std::vector<std::uint32_t> colors(samples.size());
  std::ranges::transform(samples, colors.begin(), [](const SeenSample& sample) {
    return PackedColor(sample.encoded);
  });
  ParallelFor(slots_.grid.rows, kGrain, threads, [&](int begin, int end) {
    for (int row = begin; row < end; ++row) {
      EnterLattice(lattice, colors, row, slots_);
    }
  });
  Compare(threads);
  BoundAround();
}

/// Once: later samples only lower it.
void VoronoiMap::BoundAround() {
  const auto stride = static_cast<std::size_t>(slots_.stride());
  const std::size_t room = slots_.room();
  const auto far = [this](std::size_t cell) {
    return std::max(farthest_[kBlocks * cell], farthest_[kBlocks * cell + 1]);
  };
  std::vector<float> across(room);
  for (std::size_t i = 1; i + 1 < room; ++i) {
    across[i] = std::max(std::max(far(i - 1), far(i)), far(i + 1));
  }
  for (std::size_t i = stride; i + stride < room; ++i) {
    around_[kBlocks * i] = around_[kBlocks * i + 1] =
        std::max(std::max(across[i - stride], across[i]), across[i + stride]);
  }
}

void VoronoiMap::Insert(std::span<const SeenSample> samples, int threads) {
  ParallelFor(slots_.grid.rows, kGrain, threads, [&](int begin, int end) {
    InsertIntoRows(begin, end - 1, samples);
  });
  Compare(threads);
}

void VoronoiMap::Compare(int threads) {
  RepeatBorder();
  ParallelFor(slots_.grid.rows, kGrain, threads, [&](int begin, int end) {
    for (int row = begin; row < end; ++row) {
      CompareSlots(slots_, row, kLeastContrast, priority_ == Priority::kRoot,
                   best_gains_.data() + row * slots_.grid.columns);
    }
  });
  std::ranges::fill(changed_, 0);
}

/// Rows of cells take what they need from the samples of those beside them, so
/// that some can be worked on at once.
void VoronoiMap::InsertIntoRows(int first, int last,
                                std::span<const SeenSample> samples) {
  const auto [begin, end] =
      OfRows(samples, slots_.grid.columns, first - 1, last + 1);
  EnterSamples(samples.subspan(begin, end - begin), first, last, slots_);
}

void VoronoiMap::RepeatBorder() {
  const auto [columns, rows] = slots_.grid;
  constexpr int kLast = kSlots - kSlotColumns;  // The last row of a cell.
  const auto cell = [&](int x, int y) {
    return cells_[static_cast<std::size_t>(slots_.At(x, y))].color.begin();
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

}  // namespace rtb
