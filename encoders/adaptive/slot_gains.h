/// @file
/// SlotGains: what samples in the slots of one cell are worth while some are
/// being chosen.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "encoders/adaptive/slots.h"

namespace rtb {

/// The centers of the slots of a cell.
struct SlotCenters {
  std::array<float, kSlots> x;
  std::array<float, kSlots> y;
};

inline const SlotCenters kCenters = [] {
  SlotCenters centers;
  for (int slot = 0; slot < kSlots; ++slot) {
    centers.x[static_cast<std::size_t>(slot)] = SlotCenter(slot).x;
    centers.y[static_cast<std::size_t>(slot)] = SlotCenter(slot).y;
  }
  return centers;
}();

/// The gains of one cell.
class SlotGains {
 public:
  SlotGains(const CellSlots& slots, float cell_width)
      : slots_(slots), cell_width_(cell_width) {
    for (std::size_t i = 0; i < kSlots; ++i) {
      gains_[i] = Gain(slots.contrast[i], slots.distance2[i], slots.extent[i]);
    }
  }

  /// The slot of the largest gain, of equal ones the first.
  int Best() const {
    // By halves, which compilers turn into vectors.
    std::array<float, kSlots / 2> most;
    for (std::size_t i = 0; i < most.size(); ++i) {
      most[i] = std::max(gains_[i], gains_[i + most.size()]);
    }
    for (std::size_t half = most.size() / 2; half > 0; half /= 2) {
      for (std::size_t i = 0; i < half; ++i) {
        most[i] = std::max(most[i], most[i + half]);
      }
    }
    return static_cast<int>(std::ranges::find(gains_, most[0]) -
                            gains_.begin());
  }
  float gain(int slot) const { return gains_[At(slot)]; }
  /// From a slot's center to the nearest sample.
  float distance(int slot) const {
    return std::sqrt(slots_.distance2[At(slot)]);
  }
  bool empty(int slot) const { return slots_.extent[At(slot)] == kEmptySlot; }

  /// Counts on a sample in a slot, whose color is not known.
  void Expect(int slot, const V2f& position) {
    slots_.extent[At(slot)] = WithOneMore(slots_.extent[At(slot)]);
    // One loop over all slots, which compilers turn into vectors.
    for (std::size_t i = 0; i < kSlots; ++i) {
      const float dx = (kCenters.x[i] - position.x) * cell_width_;
      const float dy = (kCenters.y[i] - position.y) * kCellHeight;
      const float distance2 = std::min(slots_.distance2[i], dx * dx + dy * dy);
      slots_.distance2[i] = distance2;
      gains_[i] = Gain(slots_.contrast[i], distance2, slots_.extent[i]);
    }
  }

 private:
  static std::size_t At(int slot) { return static_cast<std::size_t>(slot); }

  CellSlots slots_;
  float cell_width_;
  std::array<float, kSlots> gains_;
};

}  // namespace rtb
