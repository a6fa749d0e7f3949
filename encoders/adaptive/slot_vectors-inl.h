/// @file
/// Vectors over the slots of a cell: slot_kernels.cc includes this once for
/// each target, as Highway's -inl.h are.
// NOLINTNEXTLINE(llvm-header-guard)
#if defined(RTB_SLOT_VECTORS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTB_SLOT_VECTORS_INL_H_
#undef RTB_SLOT_VECTORS_INL_H_
#else
#define RTB_SLOT_VECTORS_INL_H_
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "encoders/adaptive/slot_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Whole rows of a cell's slots: 1, 2 or 4 of them.
using SlotFloats = hn::CappedTag<float, 16>;
using SlotInts = hn::RebindToSigned<SlotFloats>;
using F = hn::Vec<SlotFloats>;
using M = hn::Mask<SlotFloats>;

static_assert(kSlotColumns == 4, "a row of slots fills 128 bits");

HWY_INLINE F Same(float v) { return hn::Set(SlotFloats(), v); }
HWY_INLINE F Load(const float* from) { return hn::LoadU(SlotFloats(), from); }
HWY_INLINE void Store(F v, float* to) { hn::StoreU(v, SlotFloats(), to); }

/// The column and the row of each slot.
struct SlotPlaces {
  HWY_ALIGN float column[kSlots];
  HWY_ALIGN float row[kSlots];

  constexpr SlotPlaces() : column(), row() {
    for (int i = 0; i < kSlots; ++i) {
      column[i] = static_cast<float>(i % kSlotColumns);
      row[i] = static_cast<float>(i / kSlotColumns);
    }
  }
};
inline constexpr SlotPlaces kPlaces;

inline constexpr int kLanes = static_cast<int>(hn::MaxLanes(SlotFloats()));
inline constexpr int kVectors = kSlots / kLanes;  ///< Of a cell.

/// Whether the slots from i on have other columns than those before.
HWY_INLINE bool NewColumns(int i) { return i == 0 || kLanes < kSlotColumns; }

/// A bit for each lane.
HWY_INLINE std::uint32_t BitsOf(M mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(SlotFloats(), mask, bytes);
  return bytes[0] | static_cast<std::uint32_t>(bytes[1]) << 8;
}

/// The function of that name in slots.h.
HWY_INLINE F GainOf(F contrast, F distance2, F extent) {
  const F area = hn::Add(distance2, extent);
  return hn::Mul(hn::Mul(hn::Mul(contrast, area), area), hn::Sqrt(area));
}

/// @name Of the slots from i on their neighbors.
/// @param cell the slots of a cell.
/// @param row from a row of cells to the next.
/// @{
#if HWY_TARGET == HWY_SCALAR
HWY_INLINE F LeftOf(const float* cell, int i) {
  return Load(cell + i - 1 -
              (i % kSlotColumns == 0 ? kSlots - kSlotColumns : 0));
}
HWY_INLINE F RightOf(const float* cell, int i) {
  return Load(
      cell + i + 1 +
      (i % kSlotColumns == kSlotColumns - 1 ? kSlots - kSlotColumns : 0));
}
HWY_INLINE F AboveOf(const float* cell, int i, std::ptrdiff_t row) {
  return Load(cell + i - kSlotColumns + (i < kSlotColumns ? kSlots - row : 0));
}
HWY_INLINE F BelowOf(const float* cell, int i, std::ptrdiff_t row) {
  return Load(cell + i + kSlotColumns +
              (i + kSlotColumns >= kSlots ? row - kSlots : 0));
}
#else
HWY_INLINE F LeftOf(const float* cell, int i) {
  return hn::CombineShiftRightBytes<12>(SlotFloats(), Load(cell + i),
                                        Load(cell + i - kSlots));
}
HWY_INLINE F RightOf(const float* cell, int i) {
  return hn::CombineShiftRightBytes<4>(SlotFloats(), Load(cell + i + kSlots),
                                       Load(cell + i));
}
HWY_INLINE F AboveOf(const float* cell, int i, std::ptrdiff_t row) {
  const F above = Load(cell + i - kSlotColumns);
  if (i > 0) return above;
  const SlotFloats d;
  return hn::IfThenElse(hn::FirstN(d, kSlotColumns),
                        hn::LoadDup128(d, cell - row + kSlots - kSlotColumns),
                        above);
}
HWY_INLINE F BelowOf(const float* cell, int i, std::ptrdiff_t row) {
  const F below = Load(cell + i + kSlotColumns);
  if (i + kLanes < kSlots) return below;
  const SlotFloats d;
  return hn::IfThenElse(
      hn::FirstN(d, static_cast<std::size_t>(kLanes - kSlotColumns)), below,
      hn::LoadDup128(d, cell + row));
}
#endif
/// @}

/// The slot of the largest gain.
struct BestSlot {
  int slot;
  float gain, distance2, extent;
};

/// What samples in the slots of a cell are worth while some are being chosen.
/// The vectors of a cell stay in registers where there are enough.
class CellGains {
 public:
  HWY_INLINE explicit CellGains(const CellChoice& choice) : choice_(choice) {
    for (int v = 0; v < kVectors; ++v) {
      contrasts_[v] = Load(choice.contrast + v * kLanes);
      distances2_[v] = Load(choice.distance2 + v * kLanes);
      extents_[v] = Load(choice.extent + v * kLanes);
      Renew(v);
    }
  }

  /// How many slots gain so much.
  HWY_INLINE std::size_t CountFrom(float least) const {
    std::size_t count = 0;
    for (int v = 0; v < kVectors; ++v) {
      count += hn::CountTrue(SlotFloats(), hn::Ge(gains_[v], Same(least)));
    }
    return count;
  }

  /// Of equal ones the first.
  HWY_INLINE BestSlot Best() const {
    const SlotFloats d;
    F most = gains_[0];
    for (int v = 1; v < kVectors; ++v) most = hn::Max(most, gains_[v]);
    most = hn::MaxOfLanes(d, most);
    std::intptr_t slot = 0;
    for (int v = kVectors; v-- > 0;) {
      const std::intptr_t at = hn::FindFirstTrue(d, hn::Eq(gains_[v], most));
      if (at >= 0) slot = v * kLanes + at;
    }
    return {static_cast<int>(slot), hn::GetLane(most), distance2_[slot],
            extent_[slot]};
  }

  /// What a slot gains after a sample in it, whose extent is then another.
  HWY_INLINE float GainAfter(const BestSlot& best, float extent,
                             const V2f& position) const {
    const V2f center = SlotCenter(best.slot);
    const float dx = (center.x - position.x) * choice_.cell_width;
    const float dy = (center.y - position.y) * kCellHeight;
    const float now = dx * dx + dy * dy;
    return Gain(choice_.contrast[best.slot],
                now < best.distance2 ? now : best.distance2, extent);
  }

  /// Counts on a sample in a slot, whose extent is then another.
  HWY_INLINE void Expect(int slot, float extent, const V2f& position) {
    F dx2 = Same(0.0f);
    const F at = Same(static_cast<float>(slot));
    for (int v = 0; v < kVectors; ++v) {
      const int i = v * kLanes;
      if (NewColumns(i)) {
        dx2 = Away(kPlaces.column + i, kSlotColumns, position.x,
                   choice_.cell_width);
      }
      const F dy2 = Away(kPlaces.row + i, kSlotRows, position.y, kCellHeight);
      const auto here =
          hn::Eq(hn::Iota(SlotFloats(), static_cast<float>(i)), at);
      distances2_[v] = hn::Min(distances2_[v], hn::Add(dx2, dy2));
      extents_[v] = hn::IfThenElse(here, Same(extent), extents_[v]);
      Renew(v);
    }
  }

 private:
  /// The squared distance of slots from a place, along one axis.
  static HWY_INLINE F Away(const float* index, int count, float place,
                           float size) {
    const F center = hn::Mul(hn::Add(Load(index), Same(0.5f)),
                             Same(1 / static_cast<float>(count)));
    const F away = hn::Mul(hn::Sub(center, Same(place)), Same(size));
    return hn::Mul(away, away);
  }

  HWY_INLINE void Renew(int v) {
    gains_[v] = GainOf(contrasts_[v], distances2_[v], extents_[v]);
    hn::Store(distances2_[v], SlotFloats(), distance2_ + v * kLanes);
    hn::Store(extents_[v], SlotFloats(), extent_ + v * kLanes);
  }

  const CellChoice& choice_;
  F contrasts_[kVectors];
  F distances2_[kVectors];
  F extents_[kVectors];
  F gains_[kVectors];
  /// The same, for single slots.
  HWY_ALIGN float distance2_[kSlots];
  HWY_ALIGN float extent_[kSlots];
};

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace rtb
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
