/// @file
/// SlotGains: what samples in the slots of one cell are worth while some are
/// being chosen.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "encoders/adaptive/slots.h"

namespace rtb {

/// The gains of one cell.
class SlotGains {
 public:
  SlotGains(const CellSlots& slots, float cell_width)
      : slots_(slots), pitch_x_(cell_width / kSlotColumns) {
    for (std::size_t i = 0; i < kSlots; ++i) {
      gains_[i] = Gain(slots.contrast[i], slots.distance2[i], slots.extent[i]);
    }
  }

  /// The slot of the largest gain, of equal ones the first.
  int Best() const {
    std::array<float, kSlotColumns> columns{};
    for (std::size_t i = 0; i < kSlots; ++i) {
      float& best = columns[i % kSlotColumns];
      best = best > gains_[i] ? best : gains_[i];
    }
    const float best = std::ranges::max(columns);
    return static_cast<int>(std::ranges::find(gains_, best) - gains_.begin());
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
    const float x = position.x * kSlotColumns - 0.5f;
    const float y = position.y * kSlotRows - 0.5f;
    for (int j = 0; j < kSlotRows; ++j) {
      const float dy = (static_cast<float>(j) - y) * (kCellHeight / kSlotRows);
      for (int i = 0; i < kSlotColumns; ++i) {
        const auto at = static_cast<std::size_t>(j * kSlotColumns + i);
        const float dx = (static_cast<float>(i) - x) * pitch_x_;
        const float distance2 = dx * dx + dy * dy;
        const float old = slots_.distance2[at];
        slots_.distance2[at] = distance2 < old ? distance2 : old;
        gains_[at] =
            Gain(slots_.contrast[at], slots_.distance2[at], slots_.extent[at]);
      }
    }
  }

 private:
  static std::size_t At(int slot) { return static_cast<std::size_t>(slot); }

  CellSlots slots_;
  float pitch_x_;
  std::array<float, kSlots> gains_;
};

}  // namespace rtb
