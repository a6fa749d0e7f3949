#include "encoders/adaptive/choose_in_cell.h"

#include <algorithm>
#include <cmath>

#include "core/math/random.h"

// This file is compiled once for each target.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "encoders/adaptive/choose_in_cell.cc"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "encoders/adaptive/cell_gains-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {

HWY_INLINE V2f Jittered(int slot, float jitter, const CellChoice& choice,
                        int number) {
  const auto pixel = static_cast<std::uint32_t>(choice.cell);
  const auto sample = static_cast<std::uint32_t>(number);
  const V2f unit(UnitFloat(RandomBits(pixel, sample, 0, choice.seed)),
                 UnitFloat(RandomBits(pixel, sample, 1, choice.seed)));
  return SlotCenter(slot) + (unit - V2f(0.5f, 0.5f)) *
                                V2f(jitter / kSlotColumns, jitter / kSlotRows);
}

int ChooseRaysInCell(const CellChoice& choice, RayChoice* out) {
  CellGains cell(choice);
  for (int i = 0; i < choice.most; ++i) {
    const std::size_t slots = cell.CountFrom(choice.least);
    if (slots == 0) return i;
    const BestSlot best = cell.Best();
    const bool first = best.extent == kEmptySlot;
    const V2f position = Jittered(best.slot, first ? kFirstJitter : kJitter,
                                  choice, choice.seen + i);
    const float reach = kReach * std::sqrt(best.distance2) + kLeastReach;
    out[i] = {choice.cell, position, best.gain, std::min(reach, kCellHeight)};
    if (i + 1 == choice.most) break;
    // The usual one needs no division.
    const float extent =
        first ? WithOneMore(kEmptySlot) : WithOneMore(best.extent);
    // No sample makes another slot gain more.
    if (slots == 1 && cell.GainAfter(best, extent, position) < choice.least) {
      return i + 1;
    }
    cell.Expect(best.slot, extent, position);
  }
  return choice.most;
}

// NOLINTNEXTLINE(google-readability-namespace-comments)
}  // namespace HWY_NAMESPACE
}  // namespace rtb
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rtb {

HWY_EXPORT(ChooseRaysInCell);

int ChooseInCell(const CellChoice& choice, RayChoice* out) {
  return HWY_DYNAMIC_DISPATCH(ChooseRaysInCell)(choice, out);
}

}  // namespace rtb
#endif  // HWY_ONCE
