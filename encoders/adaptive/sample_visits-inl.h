/// @file
/// Visits: which slots samples are nearest to, block by block. Included once
/// for each target, as slot_vectors-inl.h.
// NOLINTNEXTLINE(llvm-header-guard)
#if defined(RTB_SAMPLE_VISITS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTB_SAMPLE_VISITS_INL_H_
#undef RTB_SAMPLE_VISITS_INL_H_
#else
#define RTB_SAMPLE_VISITS_INL_H_
#endif

#include <hwy/cache_control.h>
#include <hwy/highway.h>

#include <algorithm>
#include <array>

#include "encoders/adaptive/slot_kernels.h"
#include "encoders/adaptive/slot_vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {

/// Samples that are looked at together. First it is found which blocks each may
/// change, then these are changed: in either loop nothing waits for a guess.
constexpr std::size_t kTogether = 64;

/// Visits so much later are fetched from memory already.
constexpr std::size_t kAhead = 12;

/// A sample and a block that it may be nearest in.
struct Visit {
  std::uint32_t block;  ///< Those of one cell follow each other.
  float x, y;           ///< The sample's place from the block's corner.
  std::uint32_t color;
};

HWY_INLINE void EnterBlock(const Visit& visit, const SlotGrid& slots) {
  const SlotWords words;
  CellSlots& cell = slots.cells[visit.block / kBlocks];
  const int first = static_cast<int>(visit.block % kBlocks) * kBlockSlots;
  std::uint32_t changed = 0;
  for (int v = 0; v < kBlockSlots; v += kLanes) {
    const int i = first + v;
    float* const distance2 = cell.distance2.data() + i;
    std::uint32_t* const color = cell.color.data() + i;
    const F now = DistanceOf(v, slots.cell_width, visit.x, visit.y);
    const F before = Load(distance2);
    const M nearer = hn::Lt(now, before);
    // Whole, since they are soon read again.
    Store(hn::Min(now, before), distance2);
    hn::StoreU(
        hn::IfThenElse(hn::RebindMask(words, nearer),
                       hn::Set(words, visit.color), hn::LoadU(words, color)),
        words, color);
    changed |= BitsOf(nearer) << i;
  }
  slots.changed[visit.block / kBlocks] |= changed;
}

/// A sample's place among the three blocks that surround it along an axis.
struct Surrounding {
  std::array<float, 3> at;     ///< From each of their corners.
  std::array<float, 3> away2;  ///< To the nearest slots' centers, squared.
};

/// @param size of a block, @param pitch of its slots.
HWY_INLINE Surrounding Around(float at, float size, float pitch) {
  Surrounding around;
  around.at = {at + size, at, at - size};
  const float before = around.at[0] - (size - 0.5f * pitch);
  const float after = 0.5f * pitch - around.at[2];
  around.away2 = {before * before, 0, after * after};
  return around;
}

/// Where a sample lies.
struct Place {
  std::ptrdiff_t cell;  ///< See SlotGrid::At.
  int row;              ///< Of the cell.
  int half;             ///< Of the cell: 0 the upper one, 1 the lower one.
};

/// The blocks around samples' own, in which these may be nearest to a slot.
class Visits {
 public:
  HWY_INLINE Visits(const SlotGrid& slots, int first, int last)
      : slots_(slots), first_(first), last_(last) {}

  HWY_INLINE void Clear() { count_ = 0; }

  HWY_INLINE void Add(const SeenSample& sample, const Place& place) {
    const auto [cell, row, half] = place;
    const float width = slots_.cell_width;
    const float y = sample.position.y * kCellHeight -
                    static_cast<float>(half) * kBlockHeight;
    const Surrounding across =
        Around(sample.position.x * width, width, width / kSlotColumns);
    const Surrounding down = Around(y, kBlockHeight, kCellHeight / kSlotRows);
    const std::uint32_t color = PackedColor(sample.encoded);
    const auto block = kBlocks * cell + half;
    const auto other = 1 - half;
    const std::ptrdiff_t stride = slots_.stride();
    const std::array<Row, 3> rows = {
        Row{kBlocks * (cell - other * stride) + other, In(row - other), 0},
        Row{block, In(row), 1},
        Row{kBlocks * (cell + half * stride) + other, In(row + half), 2}};
    // Blocks on the far sides are out of reach but for the picture's borders.
    const float near_x = std::min(across.away2[0], across.away2[2]);
    const float far_x = std::max(across.away2[0], across.away2[2]);
    const float far_y = std::max(down.away2[0], down.away2[2]);
    if (std::min(far_x, far_y) >= slots_.around[block]) {
      const std::size_t x = across.away2[0] == near_x ? 0 : 2;
      const Row& beside = down.away2[0] == far_y ? rows[2] : rows[0];
      AddBlock(color, rows[1], 1, across, down);
      AddBlock(color, rows[1], x, across, down);
      AddBlock(color, beside, 1, across, down);
      AddBlock(color, beside, x, across, down);
      return;
    }
    for (const Row& each : rows) {
      for (std::size_t x = 0; x < 3; ++x) {
        AddBlock(color, each, x, across, down);
      }
    }
  }

  HWY_INLINE void Enter() const {
    for (std::size_t i = 0; i < count_; ++i) {
      const auto later = visits_[std::min(i + kAhead, count_ - 1)].block;
      const CellSlots& cell = slots_.cells[later / kBlocks];
      const std::size_t first = later % kBlocks * kBlockSlots;
      hwy::Prefetch(&cell.distance2[first]);
      hwy::Prefetch(&cell.color[first]);
      EnterBlock(visits_[i], slots_);
    }
  }

 private:
  HWY_INLINE bool In(int row) const {
    return static_cast<bool>((row >= first_) & (row <= last_));
  }

  /// Three blocks.
  struct Row {
    std::ptrdiff_t middle;
    bool in;  ///< Whether they are to be entered into.
    std::size_t y;
  };

  HWY_INLINE void AddBlock(std::uint32_t color, const Row& row, std::size_t x,
                           const Surrounding& across, const Surrounding& down) {
    const auto at = row.middle + kBlocks * (static_cast<std::ptrdiff_t>(x) - 1);
    visits_[count_] = {static_cast<std::uint32_t>(at), across.at[x],
                       down.at[row.y], color};
    // Without a branch, which would be a guess.
    count_ += static_cast<std::size_t>(
        row.in & (across.away2[x] + down.away2[row.y] < slots_.farthest[at]));
  }

  const SlotGrid& slots_;
  int first_, last_;
  std::size_t count_ = 0;
  std::array<Visit, 9 * kTogether + 1> visits_;  ///< One to write past them.
};

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace rtb
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
