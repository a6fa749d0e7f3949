/// @file
/// CellGains: which slot of a cell is the best for a sample, and what is left
/// to gain after it. Included once for each target, as slot_vectors-inl.h.
// NOLINTNEXTLINE(llvm-header-guard)
#if defined(RTB_CELL_GAINS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef RTB_CELL_GAINS_INL_H_
#undef RTB_CELL_GAINS_INL_H_
#else
#define RTB_CELL_GAINS_INL_H_
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>

#include "encoders/adaptive/choose_in_cell.h"
#include "encoders/adaptive/slot_vectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rtb {
namespace HWY_NAMESPACE {

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
