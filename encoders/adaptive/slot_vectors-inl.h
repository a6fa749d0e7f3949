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
#include <cstring>

#include "encoders/adaptive/slots.h"

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Whole rows of a cell's slots, 1, 2 or 4 of them, but for single lanes.
using SlotFloats = hn::CappedTag<float, 16>;
using SlotInts = hn::RebindToSigned<SlotFloats>;
using SlotWords = hn::RebindToUnsigned<SlotFloats>;
using SlotBytes = hn::Rebind<std::uint8_t, SlotFloats>;
using F = hn::Vec<SlotFloats>;
using W = hn::Vec<SlotWords>;
using M = hn::Mask<SlotFloats>;

static_assert(kSlotColumns == 4, "a row of slots fills 128 bits");

HWY_INLINE F Same(float v) { return hn::Set(SlotFloats(), v); }
HWY_INLINE F Load(const float* from) { return hn::LoadU(SlotFloats(), from); }
HWY_INLINE void Store(F v, float* to) { hn::StoreU(v, SlotFloats(), to); }

/// The centers of a cell's slots, in slots.
struct SlotPlaces {
  HWY_ALIGN float column[kSlots];
  HWY_ALIGN float row[kSlots];

  constexpr SlotPlaces() : column(), row() {
    for (int i = 0; i < kSlots; ++i) {
      column[i] = static_cast<float>(i % kSlotColumns) + 0.5f;
      row[i] = static_cast<float>(i / kSlotColumns) + 0.5f;
    }
  }
};
inline constexpr SlotPlaces kPlaces;

inline constexpr int kLanes = static_cast<int>(hn::MaxLanes(SlotFloats()));
inline constexpr int kVectors = kSlots / kLanes;  ///< Of a cell.

/// A bit for each lane.
HWY_INLINE std::uint32_t BitsOf(M mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(SlotFloats(), mask, bytes);
  std::uint32_t bits;
  std::memcpy(&bits, bytes, sizeof(bits));
  return bits;
}

/// The function of that name in slots.h.
HWY_INLINE F GainOf(F contrast, F distance2, F extent) {
  const F area = hn::Add(distance2, extent);
  const F area2 = hn::Mul(area, area);
  return hn::Mul(hn::Mul(contrast, hn::Mul(area2, area2)), area);
}

/// The function of that name in slots.h, of the slots from i on.
HWY_INLINE F ExtentsOf(const CellSlots& cell, int i) {
  const auto samples = hn::PromoteTo(
      SlotInts(), hn::LoadU(SlotBytes(), cell.samples.data() + i));
  return hn::Div(Same(kEmptySlot),
                 hn::Add(hn::ConvertTo(SlotFloats(), samples), Same(1.0f)));
}

/// The squared distances of slots from a place.
/// @param x,y that place, from the first slot's cell's or block's corner.
/// @param slot of the first lane, counted from there.
HWY_INLINE F DistanceOf(int slot, float cell_width, float x, float y) {
  const F column = Load(kPlaces.column + slot);
  const F row = Load(kPlaces.row + slot);
  const F dx =
      hn::Sub(hn::Mul(column, Same(cell_width / kSlotColumns)), Same(x));
  const F dy = hn::Sub(hn::Mul(row, Same(kCellHeight / kSlotRows)), Same(y));
  return hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy));
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace rtb
HWY_AFTER_NAMESPACE();

#endif  // per-target include guard
