/// @file
/// The colors beside slots. Included once for each target, as
/// slot_vectors-inl.h.
// NOLINTNEXTLINE(llvm-header-guard)
#if defined(RTB_SLOT_NEIGHBORS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTB_SLOT_NEIGHBORS_INL_H_
#undef RTB_SLOT_NEIGHBORS_INL_H_
#else
#define RTB_SLOT_NEIGHBORS_INL_H_
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "encoders/adaptive/slot_kernels.h"
#include "encoders/adaptive/slot_vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {

// What lies before and after the colors is loaded with them, and not used.
constexpr std::size_t kVectorBytes = kLanes * sizeof(float);
static_assert(offsetof(CellSlots, color) >= kVectorBytes);
static_assert(offsetof(CellSlots, color) + sizeof(CellSlots::color) +
                  kVectorBytes <=
              sizeof(CellSlots));

/// From a slot to the same one of the next cell in a row.
constexpr std::ptrdiff_t kNextCell = sizeof(CellSlots) / sizeof(std::uint32_t);

HWY_INLINE W Word(const std::uint32_t* from) {
  return hn::LoadU(SlotWords(), from);
}

/// @name Of the slots from i on their neighbors' colors.
/// @param cell the colors of a cell's slots.
/// @param row from a row of cells to the next.
/// @{
#if HWY_TARGET == HWY_SCALAR
HWY_INLINE W LeftOf(const std::uint32_t* cell, int i) {
  return Word(cell + i - 1 +
              (i % kSlotColumns == 0 ? kSlotColumns - kNextCell : 0));
}
HWY_INLINE W RightOf(const std::uint32_t* cell, int i) {
  return Word(
      cell + i + 1 +
      (i % kSlotColumns == kSlotColumns - 1 ? kNextCell - kSlotColumns : 0));
}
HWY_INLINE W AboveOf(const std::uint32_t* cell, int i, std::ptrdiff_t row) {
  return Word(cell + i - kSlotColumns + (i < kSlotColumns ? kSlots - row : 0));
}
HWY_INLINE W BelowOf(const std::uint32_t* cell, int i, std::ptrdiff_t row) {
  return Word(cell + i + kSlotColumns +
              (i + kSlotColumns >= kSlots ? row - kSlots : 0));
}
#else
HWY_INLINE W LeftOf(const std::uint32_t* cell, int i) {
  return hn::CombineShiftRightBytes<12>(SlotWords(), Word(cell + i),
                                        Word(cell + i - kNextCell));
}
HWY_INLINE W RightOf(const std::uint32_t* cell, int i) {
  return hn::CombineShiftRightBytes<4>(SlotWords(), Word(cell + i + kNextCell),
                                       Word(cell + i));
}
HWY_INLINE W AboveOf(const std::uint32_t* cell, int i, std::ptrdiff_t row) {
  const W above = Word(cell + i - kSlotColumns);
  if (i > 0) return above;
  const SlotWords d;
  return hn::IfThenElse(hn::FirstN(d, kSlotColumns),
                        hn::LoadDup128(d, cell - row + kSlots - kSlotColumns),
                        above);
}
HWY_INLINE W BelowOf(const std::uint32_t* cell, int i, std::ptrdiff_t row) {
  const W below = Word(cell + i + kSlotColumns);
  if (i + kLanes < kSlots) return below;
  const SlotWords d;
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
