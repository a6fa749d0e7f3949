/// @file
/// SlotGains: what samples in the slots of one cell are worth while some are
/// being chosen.
#pragma once

#include <cmath>

#include "encoders/adaptive/slot_kernels.h"
#include "encoders/adaptive/voronoi_map.h"

namespace rtb {

/// The gains of one cell.
class SlotGains {
 public:
  SlotGains(const VoronoiMap& map, int cell)
      : slots_(map.Slots(cell)), cell_width_(map.cell_width()) {
    best_ = FindGains(slots_, gains_);
  }

  /// The slot of the largest gain, of equal ones the first.
  int Best() const { return best_; }
  float gain(int slot) const { return gains_[At(slot)]; }
  /// From a slot's center to the nearest sample.
  float distance(int slot) const {
    return std::sqrt(slots_.distance2[At(slot)]);
  }
  bool empty(int slot) const { return slots_.extent[At(slot)] == kEmptySlot; }

  /// Counts on a sample in a slot, whose color is not known.
  void Expect(int slot, const V2f& position) {
    slots_.extent[At(slot)] = WithOneMore(slots_.extent[At(slot)]);
    best_ = ExpectSample(position, cell_width_, slots_, gains_);
  }

 private:
  static std::size_t At(int slot) { return static_cast<std::size_t>(slot); }

  CellSlots slots_;
  float cell_width_;
  CellGains gains_;
  int best_ = 0;
};

}  // namespace rtb
