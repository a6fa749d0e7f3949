#include <hwy/cache_control.h>

#include <algorithm>
#include <vector>

#include "encoders/adaptive/slot_kernels.h"

// This file is compiled once for each target.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "encoders/adaptive/compare_slots.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "encoders/adaptive/slot_neighbors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {

/// Blocks so much later are fetched from memory already.
constexpr std::size_t kAhead = 4;

/// The squared difference of a channel.
template <int kShift>
HWY_INLINE F ChannelApart(W a, W b) {
  const SlotWords d;
  const W most = hn::Set(d, (1u << kChannelBits) - 1);
  const auto channel = [&](W color) HWY_ATTR {
    return hn::BitCast(SlotInts(),
                       hn::And(hn::ShiftRight<kShift>(color), most));
  };
  const F apart = hn::ConvertTo(SlotFloats(), hn::Sub(channel(a), channel(b)));
  return hn::Mul(apart, apart);
}

/// The squared distance of colors, in steps of a channel.
HWY_INLINE F Apart(W a, W b) {
  return hn::Add(hn::Add(ChannelApart<2 * kChannelBits>(a, b),
                         ChannelApart<kChannelBits>(a, b)),
                 ChannelApart<0>(a, b));
}

/// The larger squared distance between the colors on two sides.
HWY_INLINE F ContrastOf(const CellSlots& cell, int i, std::ptrdiff_t row) {
  const std::uint32_t* const colors = cell.color.data();
  const F steps =
      hn::Max(Apart(LeftOf(colors, i), RightOf(colors, i)),
              Apart(AboveOf(colors, i, row), BelowOf(colors, i, row)));
  return hn::Mul(steps, Same(1 / (kChannelMost * kChannelMost)));
}

/// @param block of all cells'.
HWY_INLINE void CompareBlock(const SlotGrid& slots, std::size_t block,
                             float least, bool root) {
  const SlotFloats d;
  CellSlots& cell = slots.cells[block / kBlocks];
  const int first = static_cast<int>(block % kBlocks) * kBlockSlots;
  F best = Same(0.0f);
  F far = Same(0.0f);
  for (int i = first; i < first + kBlockSlots; i += kLanes) {
    F contrast =
        hn::Add(ContrastOf(cell, i, slots.stride() * kNextCell), Same(least));
    if (!root) contrast = hn::Mul(contrast, contrast);
    Store(contrast, cell.contrast.data() + i);
    const F distance2 = Load(cell.distance2.data() + i);
    far = hn::Max(far, distance2);
    best = hn::Max(best, GainOf(contrast, distance2, ExtentsOf(cell, i)));
  }
  slots.farthest[block] = hn::GetLane(hn::MaxOfLanes(d, far));
  slots.gains[block] = hn::GetLane(hn::MaxOfLanes(d, best));
}

/// A bit for each slot of a cell with a neighbor whose color is new, and for
/// those that are new themselves.
HWY_INLINE std::uint32_t SlotsToCompare(const std::uint32_t* changed,
                                        std::ptrdiff_t stride) {
  constexpr int kLast = kSlots - kSlotColumns;
  const std::uint32_t own = *changed;
  return own | (own << kSlotColumns) | (own >> kSlotColumns) |
         (own & ~kLastColumn) << 1 | (own & ~kFirstColumn) >> 1 |
         (changed[-1] & kLastColumn) >> (kSlotColumns - 1) |
         (changed[1] & kFirstColumn) << (kSlotColumns - 1) |
         changed[-stride] >> kLast | changed[stride] << kLast;
}

/// The blocks of a row of cells that are to be compared.
std::vector<std::size_t> BlocksToCompare(const SlotGrid& slots, int row) {
  constexpr std::uint32_t kFirstBlock = (1u << kBlockSlots) - 1;
  const auto columns = static_cast<std::size_t>(slots.grid.columns);
  std::vector<std::size_t> blocks(columns * kBlocks + 1);
  const auto first = slots.At(0, row);
  std::size_t count = 0;
  for (std::size_t i = 0; i < columns; ++i) {
    const auto cell = static_cast<std::size_t>(first) + i;
    const std::uint32_t bits =
        SlotsToCompare(slots.changed + cell, slots.stride());
    for (std::size_t block = 0; block < kBlocks; ++block) {
      blocks[count] = cell * kBlocks + block;
      // Without a branch, which would be a guess.
      count += (bits >> (block * kBlockSlots) & kFirstBlock) != 0 ? 1 : 0;
    }
  }
  blocks.resize(count);
  return blocks;
}

HWY_INLINE void PrefetchBlock(const SlotGrid& slots, std::size_t block) {
  const CellSlots* const cell = slots.cells + block / kBlocks;
  const std::size_t first = block % kBlocks * kBlockSlots;
  hwy::Prefetch(&cell->color[first]);
  hwy::Prefetch(&cell->distance2[first]);
  hwy::Prefetch(&cell->contrast[first]);
  hwy::Prefetch(&cell->samples[first]);
  hwy::Prefetch(first == 0 ? &cell[-slots.stride()].color[kSlots - 1]
                           : &cell[slots.stride()].color[0]);
}

void CompareRow(const SlotGrid& slots, int row, float least, bool root,
                float* best) {
  const std::vector<std::size_t> blocks = BlocksToCompare(slots, row);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    PrefetchBlock(slots, blocks[std::min(i + kAhead, blocks.size() - 1)]);
    CompareBlock(slots, blocks[i], least, root);
  }
  const float* const gains = slots.gains + kBlocks * slots.At(0, row);
  for (int column = 0; column < slots.grid.columns; ++column) {
    best[column] =
        std::max(gains[kBlocks * column], gains[kBlocks * column + 1]);
  }
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace rtb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtb {

HWY_EXPORT(CompareRow);

void CompareSlots(const SlotGrid& slots, int row, float least, bool root,
                  float* best) {
  HWY_DYNAMIC_DISPATCH(CompareRow)(slots, row, least, root, best);
}

}  // namespace rtb
#endif  // HWY_ONCE
