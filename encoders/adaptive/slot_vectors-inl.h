/// @file
/// Vectors over the slots of a cell: what includes this does so once for each
/// target, as with Highway's -inl.h.
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

#include "encoders/adaptive/slots.h"

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

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace rtb
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
