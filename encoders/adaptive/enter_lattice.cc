#include "encoders/adaptive/slot_kernels.h"

// This file is compiled once for each target.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "encoders/adaptive/enter_lattice.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "encoders/adaptive/slot_vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {

/// The nearest samples to the slots of a cell so far.
struct NearestSamples {
  F distance2[kVectors];
  W color[kVectors];

  HWY_INLINE NearestSamples() {
    for (int v = 0; v < kVectors; ++v) {
      distance2[v] = Same(kFar2);
      color[v] = hn::Zero(SlotWords());
    }
  }

  HWY_INLINE void See(const LatticeSample& sample, std::uint32_t its_color) {
    const SlotWords words;
    for (int v = 0; v < kVectors; ++v) {
      const F now = Load(sample.distance2.data() + v * kLanes);
      const M nearer = hn::Lt(now, distance2[v]);
      distance2[v] = hn::Min(now, distance2[v]);
      color[v] = hn::IfThenElse(hn::RebindMask(words, nearer),
                                hn::Set(words, its_color), color[v]);
    }
  }

  HWY_INLINE void Give(CellSlots& cell) const {
    for (int v = 0; v < kVectors; ++v) {
      Store(distance2[v], cell.distance2.data() + v * kLanes);
      hn::StoreU(color[v], SlotWords(), cell.color.data() + v * kLanes);
    }
  }
};

void EnterLatticeRow(const Lattice& lattice,
                     std::span<const std::uint32_t> colors, int row,
                     const SlotGrid& slots) {
  const auto [columns, rows] = slots.grid;
  const auto inside = [](int i, int count) { return i >= 0 && i < count; };
  for (int column = 0; column < columns; ++column) {
    const bool border =
        row == 0 || row == rows - 1 || column == 0 || column == columns - 1;
    NearestSamples nearest;
    for (const auto& sample : border ? lattice.around : lattice.nearest) {
      const int x = column + sample.column;
      const int y = row + sample.row;
      if (border && !(inside(x, columns) && inside(y, rows))) continue;
      const auto cell = static_cast<std::size_t>(y * columns + x);
      nearest.See(sample, colors[cell * lattice.per_cell + sample.number]);
    }
    CellSlots& cell = slots.cells[slots.At(column, row)];
    nearest.Give(cell);
    cell.samples = lattice.samples;
    slots.changed[slots.At(column, row)] = ~std::uint32_t{0};
  }
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace rtb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtb {

HWY_EXPORT(EnterLatticeRow);

void EnterLattice(const Lattice& lattice, std::span<const std::uint32_t> colors,
                  int row, const SlotGrid& slots) {
  HWY_DYNAMIC_DISPATCH(EnterLatticeRow)(lattice, colors, row, slots);
}

}  // namespace rtb
#endif  // HWY_ONCE
